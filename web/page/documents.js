// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Writes the documents for users as pages of HTML: docs/README.md, what it links to, and their images.
//   node documents.js DOCS FOLDER
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';

const escape = (text) => text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;');
/** As the links of the documents call a heading. */
const idOf = (heading) =>
  heading
    .replace(/[`*]/g, '')
    .toLowerCase()
    .replace(/[^\w -]/g, '')
    .replace(/ /g, '-');

/** `pages`: the names of the documents that are written; a link to another one is its text. */
function addressOf(target, pages) {
  const [, file, anchor = ''] = /^([^#]*)(#.*)?$/.exec(target);
  if (!file || target.includes('://')) return target;
  if (file === 'README.md') return `index.html${anchor}`;
  return pages.includes(file) ? file.replace(/md$/, 'html') + anchor : null;
}

/** A line of text: code, links, images, bold and italic words. */
function inline(text, pages) {
  const kept = []; // between two characters that no text has
  const keep = (html) => `\uE000${kept.push(html) - 1}\uE000`;
  const written = escape(text)
    .replace(/`([^`]+)`/g, (_, code) => keep(`<code>${code.replace(/\\\|/g, '|')}</code>`))
    .replace(/!\[([^\]]*)\]\(([^)]+)\)/g, (_, alt, file) =>
      keep(`<img src="images/${basename(file)}" alt="${alt.replace(/"/g, '&quot;')}" />`),
    )
    .replace(/\[([^\]]+)\]\(([^)]+)\)/g, (_, name, target) => {
      const address = addressOf(target, pages);
      return address ? `${keep(`<a href="${address}">`)}${name}${keep('</a>')}` : name;
    })
    .replace(/\*\*([^*]+)\*\*/g, '<strong>$1</strong>')
    .replace(/(^|[\s(])\*([^*\s][^*]*)\*/g, '$1<em>$2</em>')
    .replace(/\\([|*_])/g, '$1');
  // What is kept may be in what is kept before it: code in the text of a link.
  let html = written;
  while (html.includes('\uE000')) html = html.replace(/\uE000(\d+)\uE000/g, (_, i) => kept[i]);
  return html;
}

const cellsOf = (row) =>
  row
    .trim()
    .replace(/^\||\|$/g, '')
    .split(/(?<!\\)\|/)
    .map((cell) => cell.trim());

/** The blocks of lines as HTML. */
function blocks(lines, pages) {
  const html = [];
  const isItem = (line) => /^(-|\d+\.) /.test(line ?? '');
  let at = 0;
  /** Takes lines while they match. */
  const take = (matches) => {
    const begin = at;
    while (at < lines.length && matches(lines[at])) ++at;
    return lines.slice(begin, at);
  };
  while (at < lines.length) {
    const line = lines[at];
    if (!line.trim() || /^<!--.*-->$/.test(line)) {
      ++at;
    } else if (line.startsWith('```')) {
      ++at;
      const code = take((next) => !next.startsWith('```'));
      ++at;
      html.push(`<pre><code>${escape(code.join('\n'))}</code></pre>`);
    } else if (line.startsWith('    ')) {
      const code = take((next) => next.startsWith('    '));
      html.push(`<pre><code>${escape(code.map((each) => each.slice(4)).join('\n'))}</code></pre>`);
    } else if (/^#+ /.test(line)) {
      const [, marks, heading] = /^(#+) (.*)$/.exec(line);
      const { length } = marks;
      html.push(`<h${length} id="${idOf(heading)}">${inline(heading, pages)}</h${length}>`);
      ++at;
    } else if (line.startsWith('|')) {
      const [head, , ...rows] = take((next) => next.startsWith('|')).map(cellsOf);
      const row = (cells, tag) =>
        `<tr>${cells.map((cell) => `<${tag}>${inline(cell, pages)}</${tag}>`).join('')}</tr>`;
      const body = rows.map((cells) => row(cells, 'td')).join('\n');
      html.push(`<table><thead>${row(head, 'th')}</thead><tbody>\n${body}\n</tbody></table>`);
    } else if (isItem(line)) {
      const tag = line.startsWith('-') ? 'ul' : 'ol';
      const items = [];
      while (isItem(lines[at])) {
        const indent = ' '.repeat(/^\S+ /.exec(lines[at])[0].length);
        const first = lines[at++].slice(indent.length);
        const rest = take((next) => next.startsWith(indent) || (!next.trim() && inItem(indent)));
        items.push(blocks([first, ...rest.map((next) => next.slice(indent.length))], pages));
      }
      html.push(`<${tag}>${items.map((item) => `<li>${item}</li>`).join('\n')}</${tag}>`);
    } else {
      const text = take(
        (next) => next.trim() && !/^(#|\||```)/.test(next) && (next === line || !isItem(next)),
      );
      html.push(`<p>${inline(text.map((each) => each.trim()).join(' '), pages)}</p>`);
    }
  }
  return html.join('\n');

  /** Whether the item goes on after this empty line. */
  function inItem(indent) {
    let next = at;
    while (next < lines.length && !lines[next].trim()) ++next;
    return next < lines.length && lines[next].startsWith(indent);
  }
}

/** A document as a page. */
export function pageOf(text, pages) {
  const title = /^# (.*)$/m.exec(text)[1];
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <title>${escape(title.replace(/`/g, ''))}: clipc</title>
    <link rel="icon" href="data:," />
    <link rel="stylesheet" href="../style.css" />
  </head>
  <body class="document">
    <header><a href="index.html">All documents</a> <a href="../index.html">Try clipc</a></header>
    <main>
${blocks(text.split('\n'), pages)}
    </main>
  </body>
</html>
`;
}

/** The documents that docs/README.md links to. */
export const namesIn = (readme) =>
  [...new Set([...readme.matchAll(/\]\(([\w-]+\.md)/g)].map(([, name]) => name))].sort();

const [docs, folder] = process.argv.slice(2);
if (docs) {
  const readme = readFileSync(join(docs, 'README.md'), 'utf8');
  const pages = namesIn(readme);
  mkdirSync(join(folder, 'images'), { recursive: true });
  writeFileSync(join(folder, 'index.html'), pageOf(readme, pages));
  for (const name of pages) {
    const text = readFileSync(join(docs, name), 'utf8');
    writeFileSync(join(folder, name.replace(/md$/, 'html')), pageOf(text, pages));
    for (const [, image] of text.matchAll(/!\[[^\]]*\]\(([^)]+)\)/g))
      copyFileSync(join(docs, image), join(folder, 'images', basename(image)));
  }
}
