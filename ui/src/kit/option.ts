import type { ComponentChildren } from "preact";

/** A value with its label; `more` are props for its element. */
export type Option<T, Words = string, More = object> = readonly [
  value: T,
  words: Words,
  more?: More & { [name: `data-${string}`]: string | undefined },
];

export type Words = ComponentChildren;
