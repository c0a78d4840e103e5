// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The editor of several files, with clipc's messages at their places.
import { cpp } from '@codemirror/lang-cpp';
import { syntaxHighlighting } from '@codemirror/language';
import { lintGutter, setDiagnostics } from '@codemirror/lint';
import { EditorState } from '@codemirror/state';
import { EditorView } from '@codemirror/view';
import { classHighlighter } from '@lezer/highlight';
import { basicSetup } from 'codemirror';

export class Editor {
  #states = new Map(); // by the files' names; that of the file in view is the view's
  #diagnostics = [];
  file = '';

  /** `file`: the name of the first file. */
  constructor(parent, file, onChange) {
    this.extensions = [
      basicSetup,
      cpp(),
      lintGutter(),
      syntaxHighlighting(classHighlighter), // style.css has the colours, of light and dark
      EditorView.contentAttributes.of({ 'aria-label': 'HLSL', spellcheck: 'false' }),
      EditorView.updateListener.of((update) => update.docChanged && onChange()),
    ];
    this.first = file;
    this.file = file;
    this.view = new EditorView({ parent, extensions: this.extensions });
    this.#states.set(file, this.view.state);
  }

  get names() {
    return [...this.#states.keys()];
  }
  textOf(name) {
    return this.#stateOf(name).doc.toString();
  }
  #stateOf(name) {
    return name === this.file ? this.view.state : this.#states.get(name);
  }

  /** The text of a file, which is a new one if there is none of that name. */
  setText(name, doc) {
    if (name === this.file) {
      this.view.dispatch({ changes: { from: 0, to: this.view.state.doc.length, insert: doc } });
    } else {
      this.#states.set(name, EditorState.create({ doc, extensions: this.extensions }));
    }
  }

  /** Shows a file. */
  open(name) {
    if (name === this.file) return;
    if (this.#states.has(this.file)) this.#states.set(this.file, this.view.state);
    this.file = name;
    this.view.setState(this.#states.get(name));
    this.#mark();
  }

  /** Forgets a file, which is not the first. */
  close(name) {
    if (name === this.file) this.open(this.first);
    this.#states.delete(name);
  }

  /** The text of the first file. */
  get text() {
    return this.textOf(this.first);
  }
  set text(text) {
    this.setText(this.first, text);
  }

  /** As CompileResult has them, with the names of these files. */
  set diagnostics(diagnostics) {
    this.#diagnostics = diagnostics;
    this.#mark();
  }

  #mark() {
    const { doc } = this.view.state;
    const encoder = new TextEncoder();
    const marks = [];
    for (const diagnostic of this.#diagnostics) {
      const { severity, message, name, file, line, column = 1, endLine, endColumn } = diagnostic;
      if (!line || line > doc.lines || severity === 'note' || file !== this.file) continue;
      const at = doc.line(line);
      // Columns count bytes of UTF-8; the editor counts UTF-16.
      const place = (bytes) => {
        let seen = 0;
        let index = 0;
        for (const letter of at.text) {
          if (seen >= bytes) break;
          seen += encoder.encode(letter).length;
          index += letter.length;
        }
        return Math.min(at.from + index, at.to);
      };
      const from = place(column - 1);
      const to = Math.max(from, endLine > line ? at.to : place((endColumn ?? column + 1) - 1));
      marks.push({ from, to, severity, message: name ? `${message} [${name}]` : message });
    }
    this.view.dispatch(setDiagnostics(this.view.state, marks));
  }
}
