(() => {
  'use strict';
  const data = JSON.parse(document.getElementById('play-table').textContent);
  const raw = atob(data.numbers);
  const bytes = new DataView(Uint8Array.from(raw, letter => letter.charCodeAt(0)).buffer);
  const unit = 32000;
  const count = data.times.length;
  const end = data.times[count - 1];
  const speeds = data.times.map((_, i) => Math.cos(Math.PI * i / (count - 1)));
  const sliding = nu => 7 - (2 - nu) / (2 * (1 - nu));
  const entry = (i, j, k, n) => bytes.getInt16(2 * (3 * ((i * data.parts + j) * count + k) + n), true) / unit;
  const place = (part, size) => {
    const scaled = Math.min(Math.max(part, 0), 1) * (size - 1);
    const index = Math.min(Math.floor(scaled), size - 2);
    return [index, scaled - index];
  };

  // All instants of an impact: [force, stick radius, velocity].
  const impact = (nu, lambda) => {
    const part = lambda / sliding(nu);
    if (part >= 1) {
      return data.compressions.map((z, k) => [z * Math.sqrt(z), 0, 1 - 3.5 * (1 - speeds[k]) / lambda]);
    }
    const [i, x] = place(2 * nu, data.poissons);
    const [j, y] = place(part, data.parts);
    const mean = (k, n) => (1 - x) * ((1 - y) * entry(i, j, k, n) + y * entry(i, j + 1, k, n))
      + x * ((1 - y) * entry(i + 1, j, k, n) + y * entry(i + 1, j + 1, k, n));
    return data.times.map((_, k) => [mean(k, 0), mean(k, 1), mean(k, 2)]);
  };

  const form = document.getElementById('play-sliders');
  const number = name => parseFloat(form.elements[name].value);
  const inputs = () => ({
    nu: number('poisson'), f: 10 ** number('friction'), angle: number('angle') * Math.PI / 180,
    spin: number('spin'), size: number('size') >= 2 ? Infinity : 10 ** number('size'), moment: number('moment'),
  });
  const words = {
    poisson: at => at.nu.toFixed(2), friction: at => at.f.toPrecision(2),
    angle: at => `${(at.angle * 180 / Math.PI).toFixed(0)}°`, spin: at => at.spin.toFixed(2),
    size: at => (at.size === Infinity ? 'a plane' : at.size.toPrecision(2)), moment: at => at.moment.toFixed(2),
  };

  // Speeds over that of the ball; x along the plane, z away from it.
  const solve = at => {
    const [sin, cos] = [Math.sin(at.angle), Math.cos(at.angle)];
    const slip = sin - at.spin; // topspin carries the contact point backwards
    const lambda = Math.abs(slip) / (at.f * cos);
    const instants = impact(at.nu, lambda);
    const restitution = -instants[count - 1][2];
    const share = at.size === Infinity ? 1 : at.size ** 3 / (1 + at.size ** 3); // m_2/(m_1 + m_2)
    const push = 2 / 7 * (1 + restitution) * slip * share; // J_x/m_1
    const kick = 2 * cos * share; // J_z/m_1
    const other = at.size === Infinity ? 0 : at.size ** -3;
    return {
      ...at, slip, lambda, instants, restitution, before: [sin, -cos],
      after: [sin - push, kick - cos], spinAfter: at.spin + 2.5 * push, other: [push * other, -kick * other],
    };
  };

  const { word, arrow, balls: drawBalls } = drawing;
  const draw = (id, parts) => { document.getElementById(id).innerHTML = parts.join(''); };
  const balls = (one, time) => draw('play-balls', drawBalls(one, time));

  // Between the instants before and after a moment.
  const within = (moment, list) => {
    const time = moment * end;
    let k = data.times.findIndex(at => at >= time);
    k = Math.min(Math.max(k, 1), count - 1);
    const by = (time - data.times[k - 1]) / (data.times[k] - data.times[k - 1]);
    return list(k - 1) + Math.min(Math.max(by, 0), 1) * (list(k) - list(k - 1));
  };
  const contact = one => {
    const radius = 100 * Math.sqrt(Math.max(within(one.moment, k => data.compressions[k]), 0));
    const stick = Math.min(100 * within(one.moment, k => one.instants[k][1]), radius);
    const force = within(one.moment, k => one.instants[k][0]) * Math.sign(one.slip);
    draw('play-contact', [
      '<circle class="greatest" r="100"/>', `<circle class="slips" r="${radius.toFixed(1)}"/>`,
      `<circle class="sticks" r="${stick.toFixed(1)}"/>`, arrow(0, 0, -100 * force, 0, 'force'),
    ]);
  };
  const path = points => points.map(([x, y], i) => `${i ? 'L' : 'M'}${x.toFixed(1)},${y.toFixed(1)}`).join('');
  const axes = label => '<path class="axis" d="M0,-102V102M0,0H240"/>'
    + word(246, 4, 'start', '', label) + word(0, -108, 'start', '', 'F_x/(f F_z,max)');
  const forces = one => {
    const x = k => 230 * data.times[k] / end;
    const limit = data.compressions.map((z, k) => [x(k), -95 * z * Math.sqrt(Math.max(z, 0))]);
    const mirrored = limit.map(([at, y]) => [at, -y]).reverse();
    const line = one.instants.map(([force], k) => [x(k), -95 * force]);
    const now = [230 * one.moment, -95 * within(one.moment, k => one.instants[k][0])];
    draw('play-time', [
      `<path class="limit" d="${path(limit)}${path(mirrored).replace('M', 'L')}Z"/>`, axes('t/T'),
      `<path class="curve" d="${path(line)}"/>`, `<circle class="now" cx="${now[0].toFixed(1)}" cy="${now[1].toFixed(1)}" r="5"/>`,
    ]);
  };
  const loop = one => {
    const shift = [0];
    for (let k = 1; k < count; k += 1) {
      const mean = 0.5 * (one.instants[k][2] + one.instants[k - 1][2]);
      shift.push(shift[k - 1] + mean * (data.times[k] - data.times[k - 1]));
    }
    const [low, high] = [Math.min(...shift), Math.max(...shift)];
    const x = value => 230 * (value - low) / Math.max(high - low, 1e-9);
    const line = one.instants.map(([force], k) => [x(shift[k]), -95 * force]);
    const now = [x(within(one.moment, k => shift[k])), -95 * within(one.moment, k => one.instants[k][0])];
    draw('play-loop', [
      axes('ξ'), `<path class="curve" d="${path(line)}"/>`,
      `<circle class="now" cx="${now[0].toFixed(1)}" cy="${now[1].toFixed(1)}" r="5"/>`,
    ]);
  };
  const state = one => {
    const radius = Math.sqrt(Math.max(within(one.moment, k => data.compressions[k]), 0));
    const stick = within(one.moment, k => one.instants[k][1]);
    if (radius < 0.01) return 'apart';
    return stick < 0.01 ? 'all slides' : stick > 0.985 * radius ? 'all sticks' : 'a ring slips';
  };
  const answer = one => {
    const angle = Math.atan2(one.after[0], one.after[1]) * 180 / Math.PI;
    document.getElementById('play-answer').innerHTML = `R<sub>x</sub> = ${one.restitution.toFixed(3)}, λ = ${one.lambda.toPrecision(3)}`
      + ` (slides throughout from ${sliding(one.nu).toFixed(2)}), leaves at ${angle.toFixed(1)}°`
      + ` with R ω/v = ${one.spinAfter.toFixed(2)}; at this moment: ${state(one)}.`;
  };

  let now = null;
  const show = () => {
    const at = inputs();
    for (const [name, word] of Object.entries(words)) form.elements[name].parentElement.querySelector('output').textContent = word(at);
    now = solve(at);
    balls(now, 0); // in contact
    contact(now);
    forces(now);
    loop(now);
    answer(now);
  };
  form.addEventListener('input', show);

  // What this script finds where the exact answer is known; the browser's test looks at it.
  const misses = data.checks.map(check => {
    const found = solve({
      nu: check.poisson, f: check.friction, angle: check.angle * Math.PI / 180,
      spin: check.spin, size: Infinity, moment: 0,
    });
    return Math.abs(found.restitution - check.restitution);
  });
  form.dataset.misses = Math.max(...misses);

  let start = 0;
  const step = clock => {
    start = start || clock;
    const time = -2 + (clock - start) / 900; // in durations of the contact
    balls(now, time);
    form.elements.moment.value = Math.min(Math.max(time, 0), 1);
    now.moment = number('moment');
    contact(now);
    forces(now);
    loop(now);
    answer(now);
    if (time < 4) requestAnimationFrame(step); else show();
  };
  document.getElementById('play-run').addEventListener('click', () => {
    start = 0;
    requestAnimationFrame(step);
  });
  show();
})();
