(() => {
  const { rebound } = modules.rebound;
  const find = query => document.querySelector(query);
  const { word, balls: drawBalls } = drawing;
  const draw = (id, parts) => { document.getElementById(id).innerHTML = parts.join(''); };

  // Light, dark, or as the system has it; `?theme=dark` sets it.
  const [root, button, themes] = [document.documentElement, find('.theme'), ['auto', 'light', 'dark']];
  const dress = theme => {
    if (theme === 'auto') delete root.dataset.theme; else root.dataset.theme = theme;
    button.textContent = { auto: '◐ auto', light: '☀ light', dark: '☾ dark' }[theme];
    button.dataset.now = theme;
  };
  button.addEventListener('click', () => dress(themes[(themes.indexOf(button.dataset.now) + 1) % themes.length]));
  const asked = new URLSearchParams(location.search).get('theme');
  dress(themes.includes(asked) ? asked : 'auto');

  const form = find('#sliders');
  const number = name => parseFloat(form.elements[name].value);
  const LARGEST = 2;
  const inputs = () => ({
    angle: number('angle'), spin: number('spin'), friction: 10 ** number('friction'), poisson: number('poisson'),
    restitution: number('restitution'), inertia: number('inertia') > 0.66 ? 2 / 3 : number('inertia'),
    size: number('size') >= LARGEST ? Infinity : 10 ** number('size'),
  });
  const inertiaWord = inertia => {
    if (inertia > 0.66) return '2/3 shell';
    return inertia === 0.4 ? '0.4 solid' : inertia.toFixed(3);
  };
  const words = {
    angle: at => `${at.angle.toFixed(1)}°`, spin: at => at.spin.toFixed(2), friction: at => at.friction.toPrecision(2),
    poisson: at => at.poisson.toFixed(2), restitution: at => at.restitution.toFixed(2), inertia: at => inertiaWord(at.inertia),
    size: at => (at.size === Infinity ? 'a plane' : at.size.toPrecision(2)),
  };

  // The ball has mass, radius and speed 1; x along the plane, z away from it, so that topspin is about y.
  const impactOf = at => {
    const radians = at.angle * Math.PI / 180;
    const impact = {
      body1: { mass: 1, radius: 1, inertia: at.inertia, velocity: [Math.sin(radians), 0, -Math.cos(radians)], spin: [0, at.spin, 0] },
      poisson: at.poisson, friction: at.friction, restitution: at.restitution,
    };
    return at.size === Infinity ? impact : { ...impact, body2: { mass: at.size ** 3, radius: at.size, inertia: at.inertia } };
  };
  const leavingAngle = (x, z) => Math.atan2(x, z) * 180 / Math.PI;
  const elastic = at => {
    const after = rebound(impactOf(at));
    const [[x, , z], [otherX, , otherZ]] = after.velocities;
    return { ...after, after: [x, z], other: [otherX, otherZ], angle: leavingAngle(x, z), spinAfter: after.spins[0][1] };
  };
  // A rigid contact: it comes to rest, or slides throughout.
  const rigid = at => {
    const [sin, cos] = [Math.sin(at.angle * Math.PI / 180), Math.cos(at.angle * Math.PI / 180)];
    const share = at.size === Infinity ? 1 : at.size ** 3 / (1 + at.size ** 3);
    const slip = sin - at.spin;
    const press = (1 + at.restitution) * cos * share;
    const push = Math.sign(slip) * Math.min(Math.abs(slip) * share / (1 + 1 / at.inertia), at.friction * press);
    return { angle: leavingAngle(sin - push, press - cos), spinAfter: at.spin + push / at.inertia };
  };

  // A chart over the angle of arrival.
  const [WIDTH, HEIGHT, FULL] = [240, 240, 90];
  const steps = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60];
  const chart = (id, curves, now) => {
    const values = curves.flatMap(curve => curve.values);
    const step = steps.find(size => (Math.max(...values) - Math.min(...values, 0)) / size <= 5) ?? 90;
    const low = Math.floor(Math.min(...values, 0) / step + 1e-9) * step;
    const high = Math.max(Math.ceil(Math.max(...values) / step - 1e-9) * step, low + step);
    const x = angle => WIDTH * angle / FULL;
    const y = value => HEIGHT * (high - value) / (high - low);
    const ticks = Array.from({ length: Math.round((high - low) / step) + 1 }, (_, i) => low + i * step);
    const line = ({ kind, values: of }) => `<path class="${kind}" d="${of.map((value, i) =>
      `${i ? 'L' : 'M'}${x(angles[i]).toFixed(1)},${y(value).toFixed(1)}`).join('')}"/>`;
    draw(id, [
      ...ticks.map(value => `<path class="${Math.abs(value) < 1e-9 ? 'axis' : 'tick'}" d="M0,${y(value).toFixed(1)}H${WIDTH}"/>`
        + word(-6, y(value) + 4, 'end', '', String(Number(value.toFixed(2))).replace('-', '−'))),
      ...[0, 30, 60, 90].map(angle => `<path class="tick" d="M${x(angle)},0V${HEIGHT}"/>`
        + word(x(angle), HEIGHT + 18, 'middle', '', `${angle}°`)),
      ...curves.map(line), `<circle class="now" cx="${x(now[0]).toFixed(1)}" cy="${y(now[1]).toFixed(1)}" r="5"/>`,
    ]);
  };
  const angles = Array.from({ length: 90 }, (_, i) => Math.min(i, 89.5));
  const charts = (at, found) => {
    const over = solve => angles.map(angle => solve({ ...at, angle }));
    const [soft, hard] = [over(elastic), over(rigid)];
    const pair = name => [{ kind: 'rigid', values: hard.map(one => one[name]) }, { kind: 'curve', values: soft.map(one => one[name]) }];
    chart('leaving', pair('angle'), [at.angle, found.angle]);
    chart('turning', pair('spinAfter'), [at.angle, found.spinAfter]);
  };

  const rounded = value => Number(value.toFixed(4));
  const body = ({ mass, radius, inertia, velocity, spin }) => `{ mass: ${rounded(mass)}, radius: ${rounded(radius)}, inertia: ${inertia > 0.66 ? '2 / 3' : inertia}`
    + `${velocity ? `, velocity: [${velocity.map(rounded).join(', ')}]` : ''}${spin && spin[1] ? `, spin: [${spin.join(', ')}]` : ''} }`;
  const code = (impact, found) => `import { rebound } from 'carom-rebound';

const after = rebound({
  body1: ${body(impact.body1)},
${impact.body2 ? `  body2: ${body(impact.body2)},\n` : ''}  normal: [0, 0, 1], poisson: ${impact.poisson}, friction: ${rounded(impact.friction)}, restitution: ${impact.restitution},
});
after.velocities[0]  // [${found.velocities[0].map(rounded).join(', ')}]
after.spins[0]       // [${found.spins[0].map(rounded).join(', ')}]
after.rx             // ${rounded(found.rx)}`;
  const answer = found => `R<sub>x</sub> = ${found.rx.toFixed(4).replace('-', '−')}, leaves at ${found.angle.toFixed(1)}°`.replace('at -', 'at −')
    + ` with R ω/v = ${found.spinAfter.toFixed(3)}`.replace('-', '−')
    + `; ${(100 * (1 - found.energyAfter / found.energyBefore)).toFixed(1)} % of the energy is lost. `
    + (found.slides ? 'The contact slides from first touch to separation.' : 'The contact sticks in part.');

  let scene = null;
  const show = () => {
    const at = inputs();
    for (const [name, text] of Object.entries(words)) form.elements[name].parentElement.querySelector('output').textContent = text(at);
    const impact = impactOf(at);
    const found = elastic(at);
    const [x, , z] = impact.body1.velocity;
    scene = { ...found, size: at.size, spin: at.spin, before: [x, z] };
    draw('balls', drawBalls(scene, 0)); // in contact
    charts(at, found);
    find('#answer').innerHTML = answer(found);
    find('#code').textContent = code(impact, found);
  };
  form.addEventListener('input', show);
  for (const example of document.querySelectorAll('[data-set]')) {
    example.addEventListener('click', () => {
      for (const [name, value] of Object.entries(JSON.parse(example.dataset.set))) form.elements[name].value = value;
      show();
    });
  }

  let start = 0;
  const step = clock => {
    start = start || clock;
    const time = -2 + (clock - start) / 900; // in durations of the contact
    draw('balls', drawBalls(scene, time));
    if (time < 4) requestAnimationFrame(step); else show();
  };
  find('#run').addEventListener('click', () => {
    start = 0;
    requestAnimationFrame(step);
  });
  show();
})();
