// Opens every page of the book in a frame and looks at it: what is cut, missing, pale or wrong.
(async () => {
  localStorage.setItem('mdbook-theme', asked.theme);
  const faults = [];
  const parts = colour => (colour.match(/[\d.]+/g) || []).map(Number);
  const luminance = ([r, g, b]) => [r, g, b].map(v => v / 255)
    .map(v => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
    .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  let drawings = 0;
  for (const page of asked.pages) {
    const frame = document.createElement('iframe');
    frame.width = asked.width;
    frame.height = 900;
    frame.src = page;
    document.body.append(frame);
    await new Promise(done => { frame.onload = done; });
    await new Promise(done => { setTimeout(done, 50); });
    const [inside, view] = [frame.contentDocument, frame.contentWindow];
    const all = query => [...inside.querySelectorAll(query)];
    const fault = what => faults.push(`${page}: ${what}`);
    const root = inside.documentElement;
    if (!root.classList.contains(asked.theme)) fault(`the theme is not ${asked.theme}`);
    if (root.scrollWidth > asked.width) fault(`wider than ${asked.width}: ${root.scrollWidth}`);
    for (const image of inside.images) if (!image.naturalWidth) fault(`no picture ${image.src}`);
    for (const math of all('math')) if (/[&\\$]|<mo/.test(math.textContent)) fault(`formula: ${math.textContent}`);
    const ground = luminance(parts(view.getComputedStyle(root).backgroundColor));
    const look = (drawing, view, ground) => {
      drawings += 1;
      const box = drawing.getBoundingClientRect();
      if (box.width < 200 || box.height < 150) fault(`a drawing of ${box.width} x ${box.height} pixels`);
      if (!drawing.getAttribute('aria-label')) fault('a drawing without a description');
      for (const text of drawing.querySelectorAll('text')) {
        const own = text.getBoundingClientRect();
        const is_in = own.left >= box.left - 1 && own.right <= box.right + 1 && own.top >= box.top - 1
          && own.bottom <= box.bottom + 1;
        if (!is_in) fault(`a drawing cuts "${text.textContent}"`);
        const ink = luminance(parts(view.getComputedStyle(text).fill));
        const contrast = (Math.max(ink, ground) + 0.05) / (Math.min(ink, ground) + 0.05);
        if (contrast < 4.5) fault(`pale letters "${text.textContent}" in a drawing: ${contrast.toFixed(1)}`);
      }
    };
    for (const drawing of all('.drawing svg')) look(drawing, view, ground);
    // A picture is opened as a page in its size here; its ground is white.
    for (const image of all('img[src*="drawings/"]')) {
      const { width, height } = image.getBoundingClientRect();
      const own = document.createElement('iframe');
      [own.width, own.height, own.src] = [width, height, image.src];
      document.body.append(own);
      await new Promise(done => { own.onload = done; });
      if (!image.alt) fault(`no words for ${image.src}`);
      look(own.contentDocument.documentElement, own.contentWindow, 1);
      own.remove();
    }
    for (const figure of all('[data-drawing="memory"]')) {
      if (!(Number(figure.dataset.misses) < 1e-12)) fault(`the drawing of memory is off by ${figure.dataset.misses}`);
      const part = name => figure.querySelector(`[data-part="${name}"]`);
      if (part('controls').hidden) fault('the drawing of memory has no sliders');
      const key = new view.KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true });
      let turns = false;
      inside.addEventListener('keydown', () => { turns = true; });
      part('shift').dispatchEvent(key);
      if (turns) fault('an arrow key on a slider turns the page');
      for (const name of ['shift', 'approach']) {
        const [was, slider] = [part('says').textContent, part(name)];
        slider.value = Number(slider.value) - 0.4;
        slider.dispatchEvent(new Event('input'));
        if (part('says').textContent === was) fault(`the slider ${name} does nothing`);
      }
    }
    frame.remove();
  }
  const seen = JSON.stringify({ faults, pages: asked.pages.length, drawings });
  document.getElementById('seen').textContent = btoa(unescape(encodeURIComponent(seen)));
})();
