// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The files of the shader, a tab each: its own text, and those that it includes.
export const MAIN = 'shader.hlsl';
const NAME = /^[\w.-]+(\/[\w.-]+)*$/;

export class Files {
  #errors = new Map();

  /** `elements`: {list, name, remove}. `changed()` is called after a file is added, renamed or removed. */
  constructor({ list, name, remove }, editor, changed) {
    Object.assign(this, { list, name, remove, editor, changed });
    name.addEventListener('change', () => this.#rename(name.value.trim()));
    remove.addEventListener('click', () => {
      editor.close(editor.file);
      this.#show(MAIN);
      changed();
    });
    this.#show(MAIN);
  }

  /** The includes by their names. */
  get includes() {
    const names = this.editor.names.filter((name) => name !== MAIN);
    return Object.fromEntries(names.map((name) => [name, this.editor.textOf(name)]));
  }
  set includes(files) {
    for (const name of Object.keys(this.includes)) this.editor.close(name);
    for (const [name, text] of Object.entries(files)) {
      if (NAME.test(name) && name !== MAIN && typeof text === 'string')
        this.editor.setText(name, text);
    }
    this.#show(MAIN);
  }

  /** `diagnostics` as CompileResult has them: they are shown in their files, and each tab has the number of its errors. */
  mark(diagnostics) {
    this.#errors = new Map();
    for (const { severity, file } of diagnostics) {
      const name = this.#nameOf(file);
      if (severity !== 'note' && severity !== 'warning')
        this.#errors.set(name, (this.#errors.get(name) ?? 0) + 1);
    }
    this.editor.diagnostics = diagnostics.map((one) => ({ ...one, file: this.#nameOf(one.file) }));
    this.#showTabs();
  }

  #nameOf = (path) => (path ?? MAIN).replace(/^(\.\/)+/, '');

  #rename(name) {
    const { file, names } = this.editor;
    const isFree = NAME.test(name) && !names.includes(name);
    if (isFree) {
      this.editor.setText(name, this.editor.textOf(file));
      this.editor.close(file);
    }
    this.#show(isFree ? name : file);
    if (isFree) this.changed();
  }

  #add() {
    let number = 1;
    while (this.editor.names.includes(`include${number}.hlsli`)) ++number;
    this.editor.setText(`include${number}.hlsli`, '');
    this.#show(`include${number}.hlsli`);
    this.name.focus();
    this.name.select();
    this.changed();
  }

  #show(file) {
    this.editor.open(file);
    this.name.value = file;
    for (const element of [this.name.parentElement, this.remove]) element.hidden = file === MAIN;
    this.#showTabs();
  }

  #showTabs() {
    const button = (text, action) => {
      const made = document.createElement('button');
      made.type = 'button';
      made.textContent = text;
      made.addEventListener('click', action);
      return made;
    };
    const focused = [...this.list.children].indexOf(document.activeElement);
    const tabs = this.editor.names.map((name) => {
      const errors = this.#errors.get(name);
      const tab = button(errors ? `${name} (${errors})` : name, () => this.#show(name));
      tab.setAttribute('aria-pressed', String(name === this.editor.file));
      tab.classList.toggle('bad', Boolean(errors));
      return tab;
    });
    this.list.replaceChildren(
      ...tabs,
      button('Add an include', () => this.#add()),
    );
    this.list.children[focused]?.focus();
  }
}
