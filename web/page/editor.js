// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The editor, with clipc's messages at their places.
import { cpp } from '@codemirror/lang-cpp';
import { syntaxHighlighting } from '@codemirror/language';
import { setDiagnostics } from '@codemirror/lint';
import { EditorView } from '@codemirror/view';
import { classHighlighter } from '@lezer/highlight';
import { basicSetup } from 'codemirror';

export class Editor {
  constructor(parent, onChange) {
    this.view = new EditorView({
      parent,
      extensions: [
        basicSetup,
        cpp(),
        syntaxHighlighting(classHighlighter), // style.css has the colours, of light and dark
        EditorView.contentAttributes.of({ 'aria-label': 'HLSL', spellcheck: 'false' }),
        EditorView.updateListener.of((update) => update.docChanged && onChange()),
      ],
    });
  }

  get text() {
    return this.view.state.doc.toString();
  }
  set text(text) {
    this.view.dispatch({ changes: { from: 0, to: this.view.state.doc.length, insert: text } });
  }

  /** `diagnostics` as CompileResult has them. */
  show(diagnostics) {
    const { doc } = this.view.state;
    const encoder = new TextEncoder();
    const marks = [];
    for (const { severity, message, name, line, column = 1, endLine, endColumn } of diagnostics) {
      if (!line || line > doc.lines || severity === 'note') continue;
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
