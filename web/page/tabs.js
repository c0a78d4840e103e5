// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The texts that clipc makes of a shader, one tab each.
const TEXTS = {
  GLSL: ({ shown }) => shown.glsl || shown.hlsl || (shown.ok ? '' : shown.messages),
  Messages: ({ shown }) => shown.messages,
  'Clip table': ({ shown }) => (shown.table ? JSON.stringify(shown.table, null, 2) : ''),
  Reflection: ({ shown }) => (shown.reflection ? JSON.stringify(shown.reflection, null, 2) : ''),
  'Pixel shader': ({ shown }) => shown.pixel || shown.discard,
  'SPIR-V': ({ spirv }) => (spirv?.ok ? spirv.text : (spirv?.messages ?? '')),
};

export class Tabs {
  #list;
  #panel;
  #answer = null;
  name = 'GLSL';

  /** `chosen` is called when a person has chosen a tab. */
  constructor(list, panel, chosen) {
    this.#list = list;
    this.#panel = panel;
    const names = Object.keys(TEXTS);
    const choose = (name) => {
      this.#select(name);
      chosen();
    };
    for (const name of names) {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = name;
      button.dataset.name = name;
      button.setAttribute('role', 'tab');
      button.setAttribute('aria-controls', panel.id);
      button.addEventListener('click', () => choose(name));
      list.append(button);
    }
    list.addEventListener('keydown', (event) => {
      const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (!step) return;
      const next = (names.indexOf(this.name) + step + names.length) % names.length;
      choose(names[next]);
      list.children[next].focus();
    });
    this.#select(this.name);
  }

  /** Whether the text that is looked at takes a compile to SPIR-V. */
  get needsSpirv() {
    return this.name === 'SPIR-V';
  }

  /** `answer`: {shown, spirv}, results of compiles. */
  show(answer) {
    this.#answer = answer;
    this.#list.firstElementChild.textContent = answer.shown.hlsl ? 'HLSL' : 'GLSL';
    this.#panel.classList.toggle('bad', this.name === 'GLSL' && !answer.shown.ok);
    this.#panel.textContent = TEXTS[this.name](answer) || 'Nothing.';
  }

  #select(name) {
    this.name = name;
    for (const button of this.#list.children) {
      const isSelected = button.dataset.name === name;
      button.setAttribute('aria-selected', String(isSelected));
      button.tabIndex = isSelected ? 0 : -1;
    }
    if (this.#answer) this.show(this.#answer);
  }
}
