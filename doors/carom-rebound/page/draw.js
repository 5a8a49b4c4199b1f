// Drawings of an impact as parts of an SVG: for the page here and for that of the verification report.
const drawing = (() => {
  // Subscripts: `F_x`, `F_z,max`.
  const set = text => text.replace(/_([a-z,]+)/g, '<tspan dy="3" font-size="9">$1</tspan><tspan dy="-3">\u200b</tspan>');
  const word = (x, y, anchor, kind, text) => `<text class="${kind}" x="${x.toFixed(1)}" y="${y.toFixed(1)}" text-anchor="${anchor}">${set(text)}</text>`;
  const arrow = (x, y, dx, dy, kind) => {
    const long = Math.hypot(dx, dy);
    if (long < 1) return '';
    const [u, v] = [dx / long, dy / long];
    const [ex, ey] = [x + dx, y + dy];
    const wing = side => `${(ex - 8 * u + side * 4 * v).toFixed(1)},${(ey - 8 * v - side * 4 * u).toFixed(1)}`;
    return `<path class="${kind}" d="M${x.toFixed(1)},${y.toFixed(1)}L${ex.toFixed(1)},${ey.toFixed(1)}M${wing(1)}L${ex.toFixed(1)},${ey.toFixed(1)}L${wing(-1)}"/>`;
  };
  const curl = (x, y, radius, spin, kind) => {
    if (Math.abs(spin) < 0.02) return '';
    const turn = Math.sign(spin) * Math.min(Math.abs(spin), 3) * 0.8;
    const at = angle => [x + radius * Math.sin(angle), y - radius * Math.cos(angle)];
    const [[ax, ay], [bx, by]] = [at(-turn), at(turn)];
    const [tx, ty] = [Math.sign(spin) * Math.cos(turn), Math.sign(spin) * Math.sin(turn)];
    const large = Math.abs(turn) > Math.PI / 2 ? 1 : 0;
    return `<path class="${kind}" d="M${ax.toFixed(1)},${ay.toFixed(1)}A${radius},${radius} 0 ${large} ${spin > 0 ? 1 : 0} ${bx.toFixed(1)},${by.toFixed(1)}"/>`
      + arrow(bx - 9 * tx, by - 9 * ty, 9 * tx, 9 * ty, kind);
  };
  // `time` in durations of the contact: before 0 the ball comes, after 1 it leaves.
  const balls = (one, time) => {
    const radius = 36;
    const far = one.size === Infinity ? 4000 : radius * one.size;
    const flight = 26;
    const along = time < 0 ? one.before.map(v => v * flight * time) : one.after.map(v => v * flight * Math.max(time - 1, 0));
    const moved = one.other.map(v => v * flight * Math.max(time - 1, 0));
    const [x, y] = [along[0], -radius - along[1]];
    const phase = time < 0 ? one.spin * time : one.spinAfter * Math.max(time - 1, 0);
    const spoke = [x + radius * Math.sin(phase * 0.7), y - radius * Math.cos(phase * 0.7)];
    const tail = [-70 * one.before[0], -radius + 70 * one.before[1]];
    const head = [70 * one.after[0], -radius - 70 * one.after[1]];
    const isNear = Math.abs(head[0] - tail[0]) < 40 && Math.abs(head[1] - tail[1]) < 14 && head[0] < -1;
    return [
      `<circle class="body other" cx="${moved[0].toFixed(1)}" cy="${(far - moved[1]).toFixed(1)}" r="${far}"/>`,
      `<circle class="body" cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="${radius}"/>`,
      `<path class="spoke" d="M${x.toFixed(1)},${y.toFixed(1)}L${spoke[0].toFixed(1)},${spoke[1].toFixed(1)}"/>`,
      arrow(-70 * one.before[0], -radius + 70 * one.before[1], 70 * one.before[0], -70 * one.before[1], 'before'),
      arrow(0, -radius, 70 * one.after[0], -70 * one.after[1], 'after'),
      arrow(0, Math.min(far, 60), 70 * one.other[0], -70 * one.other[1], 'after'),
      curl(0, -radius, radius + 7, one.spin, 'before'), curl(0, -radius, radius + 13, one.spinAfter, 'after'),
      word(tail[0] - 5, tail[1] + 4, 'end', 'before', 'before'),
      word(head[0] + (head[0] < -1 ? -5 : 5), head[1] + (isNear ? -12 : 4), head[0] < -1 ? 'end' : 'start', 'after', 'after'),
    ];
  };
  return { word, arrow, curl, balls };
})();
