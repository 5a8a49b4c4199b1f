// The moving picture of README and book: a ball whose contact point runs back. Where nothing moves, it shows before and after.

const BALL = { mass: 0.0329, radius: 0.01, velocity: [0.25, 0, -0.5] };
// The velocity of the contact point over that before, at equal times from touch to parting: `carom impact --history 13` of
// a new case. The module gives the last.
const CONTACT = [1, 0.979, 0.884, 0.691, 0.397, 0.023, -0.356, -0.628, -0.730, -0.677, -0.543, -0.448];
const [R, HEIGHT, X, FLOOR] = [46, 190, 330, 300];
const ARROW = 240; // pixels for 1 m/s
const [TOUCH, PART, END] = [35, 60, 92]; // per cent of the loop

const STYLE = (after, turn, last) => {
  const slow = [...CONTACT, last].map((share, i, all) =>
    `${(TOUCH + (PART - TOUCH) * i / (all.length - 1)).toFixed(1)}% { transform: scaleX(${share}) }`);
  return [
    'text { font: 19px Helvetica, Arial, sans-serif; fill: #222 } .faint { opacity: .35 } .big { font-size: 22px; font-weight: bold }',
    '.ball { fill: #dceaf4; stroke: #0066a1; stroke-width: 2 } .spoke { stroke: #0066a1; stroke-width: 2; fill: none }',
    '.arrow { fill: #b84f00 } text.point { fill: #b84f00 } .way { stroke: #888; stroke-dasharray: 4 5; fill: none }',
    '.slow { opacity: 0; animation: slow 7s linear infinite } .move { animation: move 7s linear infinite }',
    '.turn { animation: turn 7s linear infinite } .moving { opacity: 0; animation: shown 7s linear infinite }',
    '.stretch { animation: stretch 7s linear infinite }',
    `@keyframes move { 0% { transform: translate(${-HEIGHT / 2}px,${-HEIGHT}px) } ${TOUCH}%, ${PART}% { transform: none }`
      + ` ${END}%, 100% { transform: translate(${after}px,${-HEIGHT}px) } }`,
    `@keyframes turn { 0%, ${PART}% { transform: none } ${END}%, 100% { transform: rotate(${turn}deg) } }`,
    `@keyframes shown { 0%, 100% { opacity: 1 } }`,
    `@keyframes slow { 0%, ${TOUCH}% { opacity: 0 } ${TOUCH + 1}%, ${PART - 1}% { opacity: 1 } ${PART}%, 100% { opacity: 0 } }`,
    `@keyframes stretch { 0% { transform: none } ${slow.join(' ')} 100% { transform: scaleX(${last}) } }`,
    '@media (prefers-reduced-motion: reduce) { * { animation: none !important } }',
  ].join('\n');
};

const arrow = speed => {
  const [tip, side] = [ARROW * speed, Math.sign(speed)];
  return `<path class="arrow" d="M0,-3 H${(tip - 14 * side).toFixed(1)} V-9 L${tip.toFixed(1)},0 L${(tip - 14 * side).toFixed(1)},9 V3 H0 Z"/>`;
};
const disc = `<circle class="ball" r="${R}"/><path class="spoke" d="M0,${-R} V${R} M${-R},0 H${R}"/><circle r="6" cx="0" cy="${-R + 14}" fill="#0066a1"/>`;
const ghost = (x, y, turn, speed) => `<g transform="translate(${x},${y})"><g class="faint" transform="rotate(${turn})">${disc}</g>`
  + `<g transform="translate(0,${R})">${arrow(speed)}</g></g>`;

export const bounce = rebound => {
  const { velocities: [velocity], spins: [spin], rx } = rebound({ body1: BALL, poisson: 0.3, friction: 0.2 });
  const [before, back] = [BALL.velocity[0], -rx * BALL.velocity[0]];
  const after = HEIGHT * velocity[0] / velocity[2];
  const turn = spin[1] * HEIGHT / R * BALL.radius / velocity[2] * 180 / Math.PI;
  const [low, high] = [FLOOR - R, FLOOR - R - HEIGHT];
  return `${[
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 720 390" width="720" height="390" role="img" aria-label="A steel ball meets a steel floor'
      + ` obliquely. Before, its contact point moves forwards with ${before} m/s. Friction stops it and throws it back: after, it moves`
      + ` backwards with ${Math.abs(back).toFixed(3)} m/s, and the ball spins with ${spin[1].toFixed(0)} rad/s.">`,
    `<style>${STYLE(after, turn.toFixed(0), (back / before).toFixed(3))}</style>`,
    '<rect width="720" height="390" fill="#fff"/>',
    `<path class="way" d="M${X - HEIGHT / 2},${high} L${X},${low} L${(X + after).toFixed(1)},${high}"/>`,
    `<path d="M20,${FLOOR} H700" stroke="#222" stroke-width="2"/>`,
    ghost(X - HEIGHT / 2, high, 0, before), ghost((X + after).toFixed(1), high, turn.toFixed(0), back),
    `<g class="moving"><g transform="translate(${X},${low})"><g class="move"><g class="turn">${disc}</g><g transform="translate(0,${R})"><g class="stretch">`
      + `${arrow(before)}</g></g></g></g></g>`,
    `<text x="20" y="${high - 20}" class="big">before</text><text x="20" y="${high + 10}" class="point">contact point</text>`,
    `<text x="20" y="${high + 36}" class="point">${before} m/s forwards</text>`,
    `<text x="460" y="${high - 20}" class="big">after</text><text x="460" y="${high + 10}" class="point">contact point</text>`,
    `<text x="460" y="${high + 36}" class="point">${Math.abs(back).toFixed(3)} m/s backwards</text><text x="460" y="${high + 62}">spin ${spin[1].toFixed(0)} rad/s</text>`,
    `<text x="${X + 70}" y="${low + 6}" class="slow">slow motion</text>`,
    `<text x="360" y="${FLOOR + 34}" text-anchor="middle">Friction stops the contact point and throws it back, as a spring would:</text>`,
    `<text x="360" y="${FLOOR + 62}" text-anchor="middle">R_x = ${Math.abs(back).toFixed(3)} / ${before} = ${rx.toFixed(2)}</text>`,
    '</svg>',
  ].join('\n')}\n`;
};
