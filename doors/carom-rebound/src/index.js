export { InputError } from './check.js';
export { HOLLOW, SOLID, kappaOf, rx, rxOfGroups } from './groups.js';
export { rebound } from './rebound.js';
