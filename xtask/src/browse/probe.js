// Looks at the report from inside, in a frame of the width to be tested, and tells the outer page.
addEventListener('load', () => setTimeout(() => {
  const root = document.documentElement;
  const theme = new URLSearchParams(location.search).get('theme');
  root.dataset.theme = theme;
  const all = query => [...document.querySelectorAll(query)];
  for (const page of all('.page')) page.style.contentVisibility = 'visible';
  const faults = [...window.faults];

  if (root.scrollWidth > innerWidth) {
    const wide = all('main *').find(one => one.getBoundingClientRect().right > innerWidth + 1
      && !one.closest('.wide, .picture'));
    faults.push(`wider than ${innerWidth}: ${root.scrollWidth}, by ${wide ? wide.outerHTML.slice(0, 120) : '?'}`);
  }
  const pictures = all('.picture');
  for (const picture of pictures) {
    const box = picture.querySelector('svg')?.getBoundingClientRect();
    if (!box || box.width < 100 || box.height < 60) faults.push(`no picture in ${picture.closest('.page').id}`);
  }
  for (const image of document.images) if (!image.naturalWidth) faults.push(`image ${image.src.slice(0, 80)}`);
  for (const wrong of all('merror, math .fail, code.fail')) faults.push(`formula: ${wrong.textContent.slice(0, 80)}`);
  for (const math of all('math')) if (/[&\\]/.test(math.textContent)) faults.push(`formula: ${math.textContent}`);
  const ids = new Set(all('[id]').map(one => one.id));
  for (const link of all('a[href^="#"]')) {
    const to = decodeURIComponent(link.hash.slice(1));
    if (to && !ids.has(to)) faults.push(`no place for the link #${to}`);
  }

  // Contrast of words on their ground, after WCAG 2: 4.5, or 3 for large ones.
  const parts = colour => (colour.match(/[\d.]+/g) || []).map(Number);
  const luminance = ([r, g, b]) => [r, g, b].map(v => v / 255)
    .map(v => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
    .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const ground = one => {
    for (let up = one; up; up = up.parentElement) {
      const colour = parts(getComputedStyle(up).backgroundColor);
      if (colour.length === 3 || colour[3] === 1) return colour;
    }
    return [255, 255, 255];
  };
  const pale = new Set();
  const words = all('p, td, th, a, span, li, h1, h2, h3, b, small, summary, option, button, code');
  for (const one of words) {
    const own = [...one.childNodes].some(node => node.nodeType === 3 && node.textContent.trim());
    if (!own || one.closest('[hidden]')) continue;
    const style = getComputedStyle(one);
    const [ink, below] = [parts(style.color), ground(one)].map(luminance);
    const contrast = (Math.max(ink, below) + 0.05) / (Math.min(ink, below) + 0.05);
    const large = parseFloat(style.fontSize) >= 24;
    if (contrast < (large ? 3 : 4.5)) pale.add(`${one.tagName}.${one.className}: ${contrast.toFixed(2)}`);
  }
  for (const one of pale) faults.push(`pale words: ${one}`);
  const dark = luminance(ground(document.body)) < 0.2;
  if (dark !== (theme === 'dark')) faults.push(`the ground is not ${theme}`);

  // The impact to play with: right where the exact answer is known, and every slider does something.
  const play = document.getElementById('play-sliders');
  if (play) {
    if (!(Number(play.dataset.misses) < 4e-3)) faults.push(`the impact to play with is off by ${play.dataset.misses}`);
    for (const slider of play.querySelectorAll('input')) {
      const [scenes, was] = [document.querySelector('.play').innerHTML, slider.value];
      slider.value = Number(slider.min) + 0.25 * (slider.max - slider.min);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
      if (document.querySelector('.play').innerHTML === scenes) faults.push(`the slider ${slider.name} does nothing`);
      slider.value = was;
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    }
  } else {
    faults.push('no impact to play with');
  }

  // Search and filter.
  const query = document.getElementById('query');
  const state = document.getElementById('state');
  const shown = () => all('nav li[data-page]').filter(line => !line.hidden).length;
  const rows = () => all('#equations tr[data-equation]').filter(row => !row.hidden).length;
  const [pages, equations] = [shown(), rows()];
  const ask = text => { query.value = text; state.dispatchEvent(new Event('change')); };
  ask('7.48');
  if (!(rows() >= 1 && rows() < 5)) faults.push(`7.48 finds ${rows()} equations`);
  ask('Cattaneo');
  if (!(shown() > 0 && shown() < pages)) faults.push(`Cattaneo finds ${shown()} of ${pages} pages`);
  ask('');
  state.value = 'deviations';
  ask('');
  if (!(shown() > 0 && shown() < pages)) faults.push(`deviations: ${shown()} of ${pages} pages`);
  document.getElementById('clear').click();
  if (shown() !== pages || rows() !== equations) faults.push('the filter does not open again');

  const seen = { faults, width: innerWidth, pictures: pictures.length, pages, equations, load: window.opened };
  parent.postMessage(JSON.stringify(seen), '*');
}, 300));
