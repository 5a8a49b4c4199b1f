// Vectors as [x, y, z].

export const add = (a, b, factor = 1) => a.map((part, i) => part + factor * b[i]);
export const times = (a, factor) => a.map(part => part * factor);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const norm = a => Math.hypot(...a);
