// The drawings of the book: how a ball leaves a plane, elastic and rigid.

const [FRICTION, POISSON] = [0.3, 0.3];
const [LEFT, TOP, WIDTH, HEIGHT] = [48, 16, 270, 236];
const DESCRIPTION = 'A solid ball without spin meets a plane, friction 0.3, Poisson\'s ratio 0.3. First: the angle at which it '
  + 'leaves over that at which it comes. Second: the speed of its surface by spin over its speed before. The elastic ball leaves '
  + 'steeper and with more spin than the rigid one between about 22 and 65 degrees; beyond, both slide throughout and agree.';

const elastic = (rebound, radians) => {
  const velocity = [Math.sin(radians), 0, -Math.cos(radians)];
  const after = rebound({ body1: { mass: 1, radius: 1, velocity }, poisson: POISSON, friction: FRICTION });
  return { push: velocity[0] - after.velocities[0][0], radians };
};
// The contact comes to rest or slides throughout.
const rigid = radians => ({ push: Math.min(2 / 7 * Math.sin(radians), 2 * FRICTION * Math.cos(radians)), radians });

const STYLE = '<style>path { fill: none; stroke: #222; stroke-width: 1.5 } .thin { stroke-width: 1 } .dash { stroke-dasharray: 5 4 }\n'
  + '.one { stroke: #0066a1 } .two { stroke: #b84f00 } text { fill: #222; stroke: none; font: 15px Helvetica, Arial, sans-serif }\n'
  + 'text.one { fill: #0066a1; stroke: none } text.two { fill: #b84f00; stroke: none }</style>';

const angle = ({ push, radians }) => Math.atan2(Math.sin(radians) - push, Math.cos(radians)) * 180 / Math.PI;
const spin = ({ push }) => 2.5 * push;

const panel = ({ value, high, ticks, unit, title }, curves, label) => {
  const x = degrees => (LEFT + WIDTH * degrees / 90).toFixed(1);
  const y = of => (TOP + HEIGHT * (1 - of / high)).toFixed(1);
  const line = curve => curve.map((one, i) => `${i ? 'L' : 'M'}${x(one.radians * 180 / Math.PI)},${y(value(one))}`).join(' ');
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 340 300" width="340" height="300" role="img" aria-label="${label}">`,
    STYLE, '<rect width="340" height="300" fill="#fff"/>',
    `<path class="thin" d="M${LEFT},${TOP} V${TOP + HEIGHT} H${LEFT + WIDTH}"/>`,
    ...ticks.map(tick => `<text x="${LEFT - 7}" y="${Number(y(tick)) + 5}" text-anchor="end">${tick}${unit}</text>`),
    ...[0, 30, 60, 90].map(tick => `<text x="${x(tick)}" y="${TOP + HEIGHT + 20}" text-anchor="middle">${tick}°</text>`),
    `<path class="two dash" d="${line(curves.rigid)}"/>`, `<path class="one" d="${line(curves.elastic)}"/>`,
    `<text x="${LEFT + 8}" y="${TOP + 6}">${title}</text>`, ...curves.words(x, y, value), '</svg>',
  ].join('\n');
};

export const pictures = rebound => {
  const all = Array.from({ length: 90 }, (_, i) => i * Math.PI / 180);
  const curves = { elastic: all.map(radians => elastic(rebound, radians)), rigid: all.map(rigid) };
  const words = (one, other) => () => [
    `<text class="one" x="${one[0]}" y="${one[1]}">elastic</text>`, `<text class="two" x="${other[0]}" y="${other[1]}">rigid</text>`,
  ];
  return [
    panel({ value: angle, high: 90, ticks: [0, 30, 60, 90], unit: '°', title: 'angle after' }, { ...curves, words: words([200, 200], [150, 150]) }, DESCRIPTION),
    panel({ value: spin, high: 1, ticks: [0, 0.5, 1], unit: '', title: 'spin R ω/v after' }, { ...curves, words: words([120, 60], [172, 172]) }, 'The spin after the impact over the angle before.'),
  ].map(panel => `${panel}\n`);
};
