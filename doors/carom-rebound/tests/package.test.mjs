// The package as it goes out.

import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import vm from 'node:vm';
import * as whole from '../src/index.js';

const folder = fileURLToPath(new URL('..', import.meta.url));
const text = path => readFileSync(`${folder}/${path}`, 'utf8');

test('the drawings are those that the module gives', () => {
  const { status, stderr } = spawnSync(process.execPath, ['build.mjs', '--check'], { cwd: folder, encoding: 'utf8' });
  assert.equal(status, 0, stderr);
});

test('every export is declared', () => {
  const declared = [...text('src/index.d.ts').matchAll(/^export (?:class|const|function) (\w+)/gm)].map(([, name]) => name);
  assert.deepEqual(declared.sort(), Object.keys(whole).sort());
});

test('the package has the module, its types, the page and the licences', () => {
  const packed = JSON.parse(execFileSync('npm', ['pack', '--dry-run', '--json'], { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }));
  const files = packed[0].files.map(({ path }) => path).sort();
  assert.deepEqual(files, [
    'LICENSE-APACHE', 'LICENSE-MIT', 'README.md', 'index.html', 'package.json', 'src/check.js', 'src/groups.js',
    'src/index.d.ts', 'src/index.js', 'src/loss.js', 'src/rebound.js', 'src/table-data.js', 'src/table.js', 'src/vector.js',
  ].sort());
});

test('the licences are those of carom', () => {
  for (const name of ['LICENSE-APACHE', 'LICENSE-MIT']) assert.equal(text(name), text(`../../${name}`));
});

test('the page has the module and its answers', () => {
  const script = text('index.html').split('<script>')[1].split('</script>')[0];
  const part = script.slice(0, script.indexOf('// Drawings of an impact'));
  const modules = vm.runInNewContext(`${part}\nmodules`, { atob });
  for (const [kappa, lambda] of [[1, 0], [1.2, 1.5], [1.5, 3], [1.1, 9]]) {
    assert.equal(modules.groups.rx(kappa, lambda), whole.rx(kappa, lambda));
  }
  assert.ok(!/https?:|src=/.test(text('page/page.html')));
});

test('the example of the README gives what it says', async () => {
  const code = text('README.md').split('```js\n')[1].split('```')[0];
  const lines = code.split('\n').filter(line => !line.startsWith('import'));
  const said = lines.filter(line => line.includes('; // ')).map(line => line.split('//').map(part => part.trim()));
  const { rebound, rx } = whole;
  const run = new Function('rebound', 'rx', `${lines.join('\n').replaceAll(/^(.*?)\/\/.*$/gm, '$1')}\nreturn [${said.map(([left]) => left.replace(/;$/, '')).join(',')}];`);
  const near = (one, other) => (Array.isArray(one)
    ? one.length === other.length && one.every((part, i) => near(part, other[i])) : Math.abs(one - other) < 1e-4);
  run(rebound, rx).forEach((value, i) => assert.ok(near(value, JSON.parse(said[i][1])), `${said[i]}: ${value}`));
  assert.ok(said.length >= 3);
});
