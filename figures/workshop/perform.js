// perform.js - runs a program from its main to its end.
export async function perform() { throw Error('not yet'); }
