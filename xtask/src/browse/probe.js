// Looks at the report from inside, in a frame of the width to be tested, and tells the outer page.
addEventListener('load', () => setTimeout(async () => {
  const root = document.documentElement;
  const theme = new URLSearchParams(location.search).get('theme');
  root.dataset.theme = theme;
  const all = query => [...document.querySelectorAll(query)];
  for (const page of all('.page')) page.style.contentVisibility = 'visible';
  const faults = [...window.faults];
  // Observers answer with the next frames of the browser.
  const soon = async holds => {
    for (let i = 0; i < 100 && !holds(); i += 1) await new Promise(done => setTimeout(done, 50));
    return holds();
  };

  if (root.scrollWidth > innerWidth) {
    const wide = all('main *').find(one => one.getBoundingClientRect().right > innerWidth + 1
      && !one.closest('.wide, .picture'));
    faults.push(`wider than ${innerWidth}: ${root.scrollWidth}, by ${wide ? wide.outerHTML.slice(0, 120) : '?'}`);
  }
  const open = all('.wide, .picture').filter(box => !box.closest('details:not([open])'));
  const silent = () => open.filter(box =>
    (box.scrollWidth > box.clientWidth + 1) !== box.classList.contains('scrolls'));
  if (!await soon(() => !silent().length)) {
    for (const box of silent()) faults.push(`a box in ${box.closest('.page').id} does not say whether it scrolls: ${box.className}, ${box.scrollWidth} in ${box.clientWidth}`);
  }

  // Pictures: there, described, and with letters that can be read. Ticks are 13 pixels high in the drawing.
  const pictures = all('.panel > svg');
  for (const picture of pictures) {
    const { width, height } = picture.getBoundingClientRect();
    const page = picture.closest('.page').id;
    if (width < 100 || height < 60) faults.push(`no picture in ${page}`);
    const letters = 13 * width / picture.viewBox.baseVal.width;
    if (!(letters > 9.9)) faults.push(`letters of ${letters.toFixed(1)} pixels in ${page}`);
  }
  for (const picture of all('main svg')) {
    const words = picture.getAttribute('role') === 'img' && picture.getAttribute('aria-label');
    if (!words) faults.push(`a picture in ${picture.closest('.page').id} has no description`);
  }
  for (const image of document.images) {
    if (!image.naturalWidth) faults.push(`image ${image.src.slice(0, 80)}`);
    if (!image.hasAttribute('alt')) faults.push(`no description of ${image.src.slice(0, 80)}`);
  }
  for (const wrong of all('merror, math .fail, code.fail')) faults.push(`formula: ${wrong.textContent.slice(0, 80)}`);
  for (const math of all('math')) if (/[&\\]/.test(math.textContent)) faults.push(`formula: ${math.textContent}`);
  const ids = new Set();
  for (const { id } of all('[id]')) {
    if (ids.has(id)) faults.push(`two elements #${id}`);
    ids.add(id);
  }
  for (const link of all('a[href^="#"]')) {
    const to = decodeURIComponent(link.hash.slice(1));
    if (to && !ids.has(to)) faults.push(`no place for the link #${to}`);
  }
  for (const field of all('input, select, button')) {
    const label = field.getAttribute('aria-label') || field.textContent || field.closest('label')?.textContent;
    if (!label?.trim()) faults.push(`no label of ${field.outerHTML.slice(0, 80)}`);
  }

  // Contrast of words on their ground, after WCAG 2: 4.5, or 3 for large ones.
  const parts = colour => (colour.match(/[\d.]+/g) || []).map(Number);
  const luminance = ([r, g, b]) => [r, g, b].map(v => v / 255)
    .map(v => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
    .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const ground = one => {
    for (let up = one; up; up = up.parentElement) {
      const sheet = up.tagName === 'svg' && up.querySelector(':scope > rect');
      const style = getComputedStyle(sheet || up);
      const colour = parts(sheet ? style.fill : style.backgroundColor);
      if (colour.length === 3 || colour[3] === 1) return colour;
    }
    return [255, 255, 255];
  };
  const pale = new Map();
  const words = all('p, td, th, a, span, li, h1, h2, h3, b, small, summary, option, button, code, output, label, figcaption, svg text');
  for (const one of words) {
    const own = [...one.childNodes].some(node => node.nodeType === 3 && node.textContent.trim());
    if (!own || one.closest('[hidden]')) continue;
    const style = getComputedStyle(one);
    const isDrawn = one instanceof SVGElement;
    const [ink, below] = [parts(isDrawn ? style.fill : style.color), ground(one)].map(luminance);
    const contrast = (Math.max(ink, below) + 0.05) / (Math.min(ink, below) + 0.05);
    const large = !isDrawn && parseFloat(style.fontSize) >= 24;
    if (contrast < (large ? 3 : 4.5)) {
      pale.set(`${one.tagName}.${isDrawn ? style.fill : one.className}: ${contrast.toFixed(2)}`, one.closest('.page')?.id);
    }
  }
  for (const [one, page] of pale) faults.push(`pale words: ${one} in ${page}`);
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
      const [at, beside] = [slider, slider.parentElement.querySelector('output')].map(one => one.getBoundingClientRect());
      if (beside.left < at.right || Math.abs(at.top + at.bottom - beside.top - beside.bottom) > 12) {
        faults.push(`the value of the slider ${slider.name} does not stand beside it`);
      }
    }
  } else {
    faults.push('no impact to play with');
  }

  // Contents that follow: the entry of the page in view is marked, and in sight where the contents stand beside.
  const sections = all('section.page');
  const contents = document.querySelector('nav');
  const isBeside = getComputedStyle(contents).position === 'sticky';
  for (const part of [0.1, 0.95, 0.5, 0]) {
    const page = sections[Math.floor(part * sections.length)];
    page.scrollIntoView();
    const current = () => all('nav [aria-current]');
    const marked = () => current().map(line => line.dataset.page).join(' ');
    if (!await soon(() => marked() === page.dataset.page)) {
      faults.push(`the contents mark “${marked()}” at ${page.dataset.page}`);
      continue;
    }
    const [line, box] = [current()[0], contents].map(one => one.getBoundingClientRect());
    if (isBeside && (line.top < box.top || line.bottom > box.bottom)) {
      faults.push(`the entry of ${page.dataset.page} is out of sight`);
    }
  }
  scrollTo(0, 0);

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
  const none = document.getElementById('none');
  if (none.textContent) faults.push(`“${none.textContent}” where something is found`);
  ask('xylophone');
  const said = none.getBoundingClientRect();
  if (none.textContent !== 'No page mentions “xylophone”.' || said.height < 10) faults.push(`nothing found says “${none.textContent}”`);
  if (none.getAttribute('role') !== 'status') faults.push('nothing found is not announced');
  ask('');
  if (none.textContent) faults.push(`“${none.textContent}” without a question`);
  state.value = 'deviations';
  ask('');
  if (!(shown() > 0 && shown() < pages)) faults.push(`deviations: ${shown()} of ${pages} pages`);
  document.getElementById('clear').click();
  if (shown() !== pages || rows() !== equations) faults.push('the filter does not open again');

  const seen = { faults, width: innerWidth, pictures: pictures.length, pages, equations, load: window.opened };
  parent.postMessage(JSON.stringify(seen), '*');
}, 300));
