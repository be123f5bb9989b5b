/** What a sign is called: a letter, or any other name that a class gave it. */
export const namedSign = (sign: string) =>
  /^\p{L}$/u.test(sign) ? `Letter ${sign}` : `Sign “${sign}”`;
