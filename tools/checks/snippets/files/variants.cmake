set(CLIPC_SCENE_METHODS object)
set(CLIPC_SCENE_object_LOWER clip-distance)
set(CLIPC_SCENE_object_VARIANTS 1)
set(CLIPC_SCENE_object_OPTIONS --plane-space=object)
