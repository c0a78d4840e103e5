// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Drags, the wheel and the arrow keys on an image change the scene.

/** What a drag of so many pixels does, by the choice of the page; Shift and Alt choose for one drag. */
const DRAGS = {
  camera: (scene, right, down) => scene.turnCamera(right / 2, down / 2),
  plane: (scene, right, down) => scene.movePlane(-down / 150),
  turn: (scene, right, down) => scene.turnPlane(right / 2, down / 2),
};
const KEYS = { ArrowLeft: [-10, 0], ArrowRight: [10, 0], ArrowUp: [0, 10], ArrowDown: [0, -10] };

/** `choice()` is a key of DRAGS; `moved` is called after each change. */
export function steer(canvas, scene, choice, moved) {
  const drag = (event, right, down) => {
    DRAGS[event.shiftKey ? 'plane' : event.altKey ? 'turn' : choice()](scene, right, down);
    moved();
  };
  let last = null;
  canvas.addEventListener('pointerdown', (event) => {
    last = event;
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!last || !event.buttons) return;
    const [right, down] = [event.clientX - last.clientX, event.clientY - last.clientY];
    last = event;
    drag(event, right, down);
  });
  canvas.addEventListener('pointerup', () => (last = null));
  canvas.addEventListener(
    'wheel',
    (event) => {
      // The page scrolls until a person has chosen the image.
      if (document.activeElement !== canvas && !event.ctrlKey) return;
      event.preventDefault();
      scene.approach(Math.exp(event.deltaY / 1000));
      moved();
    },
    { passive: false },
  );
  canvas.addEventListener('keydown', (event) => {
    const step = KEYS[event.key];
    if (!step) return;
    event.preventDefault();
    drag(
      event,
      step[0],
      choice() === 'camera' && !event.shiftKey && !event.altKey ? step[1] : -step[1],
    );
  });
}
