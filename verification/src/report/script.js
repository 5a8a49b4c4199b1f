(() => {
  'use strict';
  const root = document.documentElement;
  const find = (query, within = document) => within.querySelector(query);
  const all = (query, within = document) => [...within.querySelectorAll(query)];

  // Light, dark, or as the system has it.
  const themes = ['auto', 'light', 'dark'];
  const button = find('.theme');
  const remembered = () => { try { return localStorage.getItem('theme'); } catch { return null; } };
  const remember = theme => { try { localStorage.setItem('theme', theme); } catch { /* not kept */ } };
  const show = theme => {
    if (theme === 'auto') delete root.dataset.theme; else root.dataset.theme = theme;
    button.textContent = { auto: '◐ auto', light: '☀ light', dark: '☾ dark' }[theme];
    button.dataset.now = theme;
  };
  button.addEventListener('click', () => {
    const next = themes[(themes.indexOf(button.dataset.now) + 1) % themes.length];
    show(next);
    remember(next);
  });
  show(themes.includes(remembered()) ? remembered() : 'auto');

  // Search and filter.
  const query = find('#query');
  const chapter = find('#chapter');
  const state = find('#state');
  const found = find('#found');
  const none = find('#none');
  const pages = new Map(all('.page').map(page => [page.dataset.page, page]));
  const lines = all('nav li[data-page]');
  const words = new Map();
  const plain = text => text.toLowerCase().replaceAll('_', '').replace(/\s+/g, ' ');
  const text = line => {
    const id = line.dataset.page;
    if (!words.has(id)) {
      const page = pages.get(id);
      words.set(id, plain(line.textContent + ' ' + (page ? page.textContent : '')));
    }
    return words.get(id);
  };
  // A number is found as a whole: 7.4 does not find 7.48, but 7.65 finds (7.65) and (7.65a).
  const test = asked => {
    const number = /^\(?(\d+\.\d+)([a-h]?)\)?$/.exec(asked);
    if (number) {
      const whole = number[1].replace('.', '\\.') + (number[2] || '[a-h]{0,2}');
      const pattern = new RegExp('(^|[^\\d.])' + whole + '(?![\\d.]|[a-z])');
      return text => pattern.test(text);
    }
    const parts = plain(asked).split(' ').filter(part => part);
    return text => parts.every(part => text.includes(part));
  };
  const fits = page => ({
    all: true,
    done: page.state === 'done',
    failing: page.fails === '1',
    partial: page.state === 'partial',
    missing: page.state === 'missing',
    deviations: page.deviates === '1',
  })[state.value];
  const rows = all('#equations tr[data-equation]');
  const filter = () => {
    const asked = query.value.trim();
    const holds = test(asked.toLowerCase());
    let count = 0;
    for (const line of lines) {
      const is = (chapter.value === 'all' || line.dataset.chapter === chapter.value)
        && fits(line.dataset) && (!asked || holds(text(line)));
      line.hidden = !is;
      const page = pages.get(line.dataset.page);
      if (page) page.hidden = !is;
      count += is ? 1 : 0;
    }
    for (const group of all('nav section')) {
      group.hidden = !all('li', group).some(line => !line.hidden);
    }
    let equations = 0;
    for (const row of rows) {
      row.hidden = !!asked && !holds(plain(row.textContent + ' ' + (row.dataset.all || '')));
      equations += row.hidden ? 0 : 1;
    }
    const filtered = asked || chapter.value !== 'all' || state.value !== 'all';
    const counted = asked && equations ? `, ${equations} equation${equations === 1 ? '' : 's'}` : '';
    found.textContent = filtered ? `${count} of ${lines.length} pages${counted}` : '';
    const chosen = chapter.value !== 'all' || state.value !== 'all';
    none.textContent = count > 0 ? '' : asked
      ? `No page${chosen ? ' of this choice' : ''} mentions “${asked}”.` : 'No page fits this choice.';
  };
  let timer = 0;
  query.addEventListener('input', () => {
    clearTimeout(timer);
    timer = setTimeout(filter, 120);
  });
  for (const choice of [chapter, state]) choice.addEventListener('change', filter);
  find('#clear').addEventListener('click', () => {
    query.value = '';
    chapter.value = state.value = 'all';
    filter();
  });
  addEventListener('keydown', event => {
    if (event.key === '/' && !/^(INPUT|SELECT|TEXTAREA)$/.test(document.activeElement.tagName)) {
      event.preventDefault();
      query.focus();
    }
  });
  // A link to a page that the filter hides shows it again.
  addEventListener('hashchange', () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const hidden = target && target.closest('[hidden]');
    if (!hidden) return;
    query.value = '';
    chapter.value = state.value = 'all';
    filter();
    target.scrollIntoView();
  });

  // The contents follow the reader: the entry of the page in view is marked and kept in sight.
  const nav = find('nav');
  const entries = new Map(lines.map(line => [line.dataset.page, line]));
  let marked = null;
  const mark = id => {
    const line = entries.get(id) || null;
    if (line === marked) return;
    if (marked) marked.removeAttribute('aria-current');
    marked = line;
    if (!line) {
      nav.scrollTop = 0;
      return;
    }
    line.setAttribute('aria-current', 'true');
    const [box, at] = [nav.getBoundingClientRect(), line.getBoundingClientRect()];
    const room = Math.min(2 * at.height, 0.2 * box.height);
    if (at.top < box.top + room || at.bottom > box.bottom - room) {
      nav.scrollTop += at.top - box.top - 0.4 * box.height;
    }
  };
  // A page is in view while it crosses a line below the bar.
  const watch = new IntersectionObserver(seen => {
    for (const { isIntersecting, target } of seen) if (isIntersecting) mark(target.dataset.page);
  }, { root: document, rootMargin: '-20% 0px -79% 0px' });
  for (const page of all('.intro, .page')) watch.observe(page);

  // The panels of a picture have one scale: two beside each other if their letters can be read, else one.
  const least = 0.78;
  const scale = picture => {
    const widths = all('.panel', picture).map(panel => Number(panel.style.getPropertyValue('--width')));
    const pairs = widths.slice(1).map((width, i) => width + widths[i]);
    const fitted = width => Math.min(1, picture.clientWidth / width);
    const [pair, one] = [fitted(Math.max(...pairs, ...widths)), fitted(Math.max(...widths))];
    picture.style.setProperty('--scale', Math.max(pair < least ? one : pair, least).toFixed(3));
  };
  // What is wider than its box says so.
  const fit = new ResizeObserver(seen => requestAnimationFrame(() => {
    for (const { target } of seen) {
      if (target.matches('.picture')) scale(target);
      target.classList.toggle('scrolls', target.scrollWidth > target.clientWidth + 1);
    }
  }));
  for (const box of all('.picture, .wide')) fit.observe(box);

  // On a phone the contents start closed; on paper nothing is.
  const contents = find('nav details');
  if (matchMedia('(max-width: 900px)').matches) contents.open = false;
  addEventListener('beforeprint', () => all('main details').forEach(one => { one.open = true; }));
})();
