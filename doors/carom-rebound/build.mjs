// Writes src/table-data.js, from the table that the library stores, and index.html, from the module and page/.
// `node build.mjs --check` compares only. Needs the sources of carom around this folder.

import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const place = path => fileURLToPath(new URL(path, import.meta.url));
const text = path => readFileSync(place(path), 'utf8');
const TABLE = '../../crates/impact/src/restitution/table/stored.bin';
const SOURCES = ['table-data', 'table', 'check', 'vector', 'groups', 'rebound'];

const data = () => {
  const lines = readFileSync(place(TABLE)).toString('base64').match(/.{1,115}/g);
  return '// Written by build.mjs from the table of R_x that the library stores: little-endian, in base 64.\n'
    + `export const data = \`\n${lines.join('\n')}\n\`;\n`;
};

// A module as part of a script: without its imports and exports, in a scope that returns what it exports.
const inlined = (name, source) => {
  const lines = source.split('\n');
  const imports = [...source.matchAll(/^import \{([^}]*)\} from '\.\/([\w-]+)\.js';$/gm)];
  const exports = [...source.matchAll(/^export (?:const|class) (\w+)/gm)].map(([, word]) => word);
  const taken = imports.map(([, words, from]) =>
    `const {${words.replaceAll(/(\w+) as (\w+)/g, '$1: $2')}} = modules['${from}'];`);
  const body = lines.filter(line => !line.startsWith('import ')).map(line => line.replace(/^export /, ''));
  return `modules['${name}'] = (() => {\n${taken.join('\n')}\n${body.join('\n')}\nreturn {${exports.join(', ')}};\n})();`;
};

const page = (table) => {
  const module = SOURCES.map(name => inlined(name, name === 'table-data' ? table : text(`src/${name}.js`)));
  const script = `'use strict';\nconst modules = {};\n${module.join('\n')}\n${text('page/draw.js')}\n${text('page/page.js')}`;
  const fill = { style: text('page/theme.css') + text('page/play.css') + text('page/page.css'), script };
  return text('page/page.html').replaceAll(/@(style|script)@/g, (_, name) => fill[name]);
};

const table = data();
const files = { 'src/table-data.js': table, 'index.html': page(table) };
const stale = Object.entries(files).filter(([path, wanted]) => {
  try { return text(path) !== wanted; } catch { return true; }
});
if (process.argv.includes('--check')) {
  for (const [path] of stale) console.error(`${path} is not current: node build.mjs`);
  process.exitCode = stale.length ? 1 : 0;
} else {
  for (const [path, wanted] of stale) writeFileSync(place(path), wanted);
}
