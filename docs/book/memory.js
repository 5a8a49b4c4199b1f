// The memory of a contact that is shifted along a line, with sliders: the anchors W(s) as a polyline, cut by the
// cone |X - W(s)| <= zeta - s. Lengths are in units of the greatest approach, forces in units of f F_z there.
'use strict';
(() => {
  // The two diagrams and the sliders, in place of the pictures that the page shows without this script.
  const markup = `
<svg viewBox="0 0 340 270" role="img" aria-label="Anchors W over depth s. The cone with its tip at the approach zeta and the shift X opens to the left. The polyline of the anchors is flat where annuli stick, and follows the side of the cone where they slip.">
<defs>
<marker id="arrow-ink" viewBox="0 0 10 10" refX="8" refY="5" markerUnits="userSpaceOnUse" markerWidth="11" markerHeight="11" orient="auto-start-reverse"><path class="ink" d="M0,0 L10,5 L0,10 L3,5 z"/></marker>
<clipPath id="memory-frame"><path d="M50,5 H320 V265 H50 z"/></clipPath>
</defs>
<g clip-path="url(#memory-frame)"><path class="patch" data-part="cone" d="M50,-13 L300,77 L50,167 Z"/></g>
<path class="line" d="M50,140 H322" marker-end="url(#arrow-ink)"/>
<path class="line" d="M50,265 V10" marker-end="url(#arrow-ink)"/>
<text class="math" x="326" y="145">s</text>
<text class="math" x="20" y="24">W</text>
<path class="arrow one" data-part="sticks" d="M50,140 L125,140"/>
<path class="arrow two" data-part="slips" d="M125,140 L300,77"/>
<circle class="ink" data-part="tip" cx="300" cy="77" r="5"/>
<text class="one" x="70" y="258">sticks</text>
<text class="two" x="130" y="258">slips</text>
</svg>
<svg viewBox="0 0 340 270" role="img" aria-label="The tangential force over the shift, between the friction limits.">
<path class="line" d="M20,140 H318" marker-end="url(#arrow-ink)"/>
<path class="line" d="M170,265 V10" marker-end="url(#arrow-ink)"/>
<text class="math" x="322" y="145">X</text>
<text class="math" x="136" y="22">F<tspan class="sub" dy="4">x</tspan></text>
<path class="thin dash" data-part="limits" d="M30,30 H310 M30,250 H310"/>
<text class="math" x="276" y="24">f F<tspan class="sub" dy="4">z</tspan></text>
<path class="arrow three" data-part="trace" d=""/>
<circle class="ink" data-part="now" cx="170" cy="140" r="5"/>
</svg>
<div class="controls" data-part="controls" hidden>
<label>Shift <input type="range" data-part="shift" min="-1.3" max="1.3" step="0.05" value="0"></label>
<label>Approach <input type="range" data-part="approach" min="0" max="1" step="0.05" value="1"></label>
<button type="button" data-part="again">Start again</button>
<output data-part="says"></output>
</div>
`;

  const fresh = { zeta: 1, x: 0, anchors: [[0, 0], [1, 0]], slipsFrom: 1 };

  /** How far an anchor lies outside the cone; negative inside. */
  const excess = ([s, w], zeta, x) => Math.abs(x - w) - (zeta - s);

  /** Where the segment from `inside` to `outside` leaves the cone. */
  function border(inside, outside, zeta, x) {
    const shares = [1, -1].map(side => {
      const [from, to] = [inside, outside].map(([s, w]) => side * (x - w) - (zeta - s));
      return to > 0 ? from / (from - to) : 1;
    });
    const share = Math.min(...shares);
    return [0, 1].map(k => inside[k] + share * (outside[k] - inside[k]));
  }

  /** The contact after a straight move to (zeta, x): anchors outside the cone are replaced by its side. */
  function moved(contact, zeta, x) {
    const anchors = contact.anchors.slice();
    let outside = null;
    while (anchors.length > 0 && excess(anchors.at(-1), zeta, x) > 0) outside = anchors.pop();
    let slipsFrom = zeta;
    if (outside !== null) {
      const side = Math.sign(x - outside[1]);
      const cut = anchors.length > 0 ? border(anchors.at(-1), outside, zeta, x) : [0, x - side * zeta];
      slipsFrom = cut[0];
      anchors.push(cut);
    }
    anchors.push([zeta, x]);
    return { zeta, x, anchors, slipsFrom };
  }

  /** F_x / (f F_z at zeta = 1): 3/2 of the integral of X - W(t^2) over t from 0 to sqrt(zeta). */
  function force({ x, anchors }) {
    let sum = 0;
    for (let k = 1; k < anchors.length; k++) {
      const [[s0, w0], [s1, w1]] = [anchors[k - 1], anchors[k]];
      if (s1 <= s0) continue;
      const slope = (w1 - w0) / (s1 - s0);
      const primitive = s => Math.sqrt(s) * (x - w0 + slope * s0 - slope * s / 3);
      sum += primitive(s1) - primitive(s0);
    }
    return 1.5 * sum;
  }

  /** The greatest deviation of `force` from known solutions: (5.27), Masing's rule, a closed loop, sliding. */
  function misses() {
    const at = (...path) => path.reduce((contact, to) => moved(contact, ...to), fresh);
    const first = x => 1 - Math.max(1 - Math.abs(x), 0) ** 1.5;
    const faults = [];
    for (const x of [0.1, 0.5, 0.9, 1.2]) {
      faults.push(force(at([1, x])) - first(x));
      faults.push(force(at([1, -x])) + first(x));
    }
    // A reversal from 0.8 to 0.8 - d changes the force by twice that of a first shift by d / 2.
    for (const d of [0.2, 0.9, 1.5]) faults.push(force(at([1, 0.8], [1, 0.8 - d])) - first(0.8) + 2 * first(d / 2));
    // A small loop inside a large one leaves no trace once it is closed.
    const open = at([1, 0.8], [1, -0.5], [1, 0.3]);
    const closed = at([1, 0.8], [1, -0.5], [1, 0.3], [1, -0.1], [1, 0.3]);
    faults.push(force(at([1, 0.8], [1, -0.5], [1, 0.1], [1, -0.5])) - force(at([1, 0.8], [1, -0.5])));
    faults.push(force(moved(closed, 1, 0.7)) - force(moved(open, 1, 0.7)));
    // A larger shift erases the reversals before it.
    const erased = [0.8, -0.5, 0.3].map(x => [1, x]);
    faults.push(force(at(...erased, [1, -0.7])) - first(0.8) + 2 * first(0.75));
    faults.push(force(at(...erased, [1, 0.9])) - first(0.9));
    // Everything slides, also after the contact has shrunk.
    faults.push(force(at([1, 0.4], [0.3, 0.9])) - 0.3 ** 1.5);
    // A contact that grows faster than it is shifted sticks: F_x = X' F_z for a path X = X' zeta from the start.
    faults.push(force(at([0, 0], [1, 0.5])) - 0.5);
    return Math.max(...faults.map(Math.abs));
  }

  /** Draws into the figure and listens to its sliders. */
  function start(figure) {
    figure.querySelector('p').outerHTML = markup;
    const find = name => figure.querySelector(`[data-part="${name}"]`);
    const [shift, approach] = ['shift', 'approach'].map(find);
    const place = ([s, w]) => `${(50 + 250 * s).toFixed(1)},${(140 - 90 * w).toFixed(1)}`;
    const spot = ([x, f]) => `${(170 + 100 * x).toFixed(1)},${(140 - 110 * f).toFixed(1)}`;
    const line = points => (points.length > 0 ? `M${points.join(' L')}` : '');
    let contact, trace;

    function draw() {
      const { zeta, x, anchors, slipsFrom } = contact;
      const limit = zeta ** 1.5;
      find('cone').setAttribute('d', `${line([[0, x + zeta], [zeta, x], [0, x - zeta]].map(place))} Z`);
      find('sticks').setAttribute('d', line(anchors.filter(([s]) => s <= slipsFrom).map(place)));
      find('slips').setAttribute('d', line(anchors.filter(([s]) => s >= slipsFrom).map(place)));
      const [cx, cy] = place([zeta, x]).split(',');
      find('tip').setAttribute('cx', cx);
      find('tip').setAttribute('cy', cy);
      find('trace').setAttribute('d', line(trace.map(spot)));
      find('limits').setAttribute('d', [limit, -limit].map(f => line([[-1.4, f], [1.4, f]].map(spot))).join(' '));
      const [fx, fy] = spot(trace.at(-1)).split(',');
      find('now').setAttribute('cx', fx);
      find('now').setAttribute('cy', fy);
      const share = zeta > 0 ? Math.sqrt(slipsFrom / zeta) : 0;
      const number = value => value.toFixed(2).replace('-0.00', '0.00').replace('-', '−');
      find('says').textContent = `Shift ${number(x)}, approach ${number(zeta)}, force ${number(force(contact))}, `
        + `stick radius ${number(share)} of the contact radius`;
    }

    /** Moves in small steps, so that the curve of the force is drawn; the result does not depend on them. */
    function go(zeta, x) {
      const from = contact;
      const count = Math.max(1, Math.ceil(Math.hypot(zeta - from.zeta, x - from.x) / 0.02));
      for (let k = 1; k <= count; k++) {
        contact = moved(contact, from.zeta + (zeta - from.zeta) * k / count, from.x + (x - from.x) * k / count);
        trace.push([contact.x, force(contact)]);
      }
      trace = trace.slice(-2000);
      draw();
    }

    function restart() {
      contact = fresh;
      trace = [[0, 0]];
      shift.value = 0;
      approach.value = 1;
      draw();
    }

    const follow = () => go(Number(approach.value), Number(shift.value));
    shift.addEventListener('input', follow);
    approach.addEventListener('input', follow);
    find('again').addEventListener('click', restart);
    // The arrow keys move a slider here; elsewhere they turn the pages of the book.
    find('controls').addEventListener('keydown', event => event.stopPropagation());
    restart();
    find('controls').hidden = false;
    for (shift.value of [0.8, 0.1]) follow();
    figure.dataset.misses = misses();
  }

  if (typeof document !== 'undefined') document.querySelectorAll('[data-drawing="memory"]').forEach(start);
})();
