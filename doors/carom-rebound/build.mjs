// Writes src/table-data.js, from the table that the library stores, and index.html, from the module and page/, which are
// not stored; and the drawings of the book and of README, which `node build.mjs --check` compares only. Needs the sources
// of carom around this folder.

import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const place = path => fileURLToPath(new URL(path, import.meta.url));
const text = path => readFileSync(place(path), 'utf8');
const FOLDER = '../../crates/impact/src/restitution/table';
const SOURCES = ['table-data', 'table', 'loss', 'check', 'vector', 'groups', 'rebound'];

const data = () => {
  const stored = (name, file) => {
    const lines = readFileSync(place(`${FOLDER}/${file}`)).toString('base64').match(/.{1,115}/g);
    return `export const ${name} = \`\n${lines.join('\n')}\n\`;\n`;
  };
  return '// Written by build.mjs from the tables of R_x that the library stores: little-endian, in base 64.\n'
    + stored('data', 'stored.bin') + stored('losses', 'loss.bin');
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

const isCheck = process.argv.includes('--check');
const finish = (files, compares) => {
  const stale = Object.entries(files).filter(([path, wanted]) => {
    try { return text(path) !== wanted; } catch { return true; }
  });
  for (const [path, wanted] of stale) {
    if (compares) console.error(`${path} is not current: node build.mjs`);
    else writeFileSync(place(path), wanted);
  }
  if (compares && stale.length) process.exitCode = 1;
};

const table = data();
finish({ 'src/table-data.js': table, 'index.html': page(table) }, false);
const [{ rebound }, { pictures }, { bounce }] = await Promise.all(
  ['./src/index.js', './picture.mjs', './bounce.mjs'].map(path => import(path)));
const [angle, spin] = pictures(rebound);
const DRAWINGS = '../../docs/book/src/drawings';
const drawn = { 'rebound-1.svg': angle, 'rebound-2.svg': spin, 'bounce.svg': bounce(rebound) };
finish(Object.fromEntries(Object.entries(drawn).map(([name, svg]) => [`${DRAWINGS}/${name}`, svg])), isCheck);
