// Checks of what a caller gives. Each error names the field, its value and what is allowed.

const shown = value => (typeof value === 'string' ? JSON.stringify(value) : String(value));

/** A value that is not of the kind asked for, or out of its range. */
export class InputError extends RangeError {
  constructor(field, value, allowed) {
    super(`${field} = ${shown(value)} must be ${allowed}`);
    this.name = 'InputError';
    this.field = field;
    this.value = value;
    this.allowed = allowed;
  }
}

/** A number for which `holds`. */
export const number = (field, value, holds, allowed) => {
  if (typeof value !== 'number' || !holds(value)) throw new InputError(field, value, allowed);
  return value;
};

/** A mass or a length: beyond these powers its square or inverse is no number. */
export const size = (field, value) =>
  number(field, value, given => given >= 1e-100 && given <= 1e100, 'a number from 1e-100 to 1e100');

/** Three finite numbers. */
export const vector = (field, value) => {
  const isVector = Array.isArray(value) || ArrayBuffer.isView(value);
  if (!isVector || value.length !== 3) throw new InputError(field, value, 'an array [x, y, z]');
  return Array.from(value, (part, i) => number(`${field}[${i}]`, part, given => Math.abs(given) <= 1e100, 'a number of at most 1e100'));
};

/** An object with none but these names. */
export const object = (field, value, names) => {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    throw new InputError(field, value, `an object with ${names.join(', ')}`);
  }
  const stranger = Object.keys(value).find(name => !names.includes(name));
  if (stranger !== undefined) {
    throw new InputError(`${field}.${stranger}`, value[stranger], `left out; ${field} has ${names.join(', ')}`);
  }
  return value;
};
