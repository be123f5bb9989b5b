import type { ComponentChildren } from "preact";

/** What one of several values is called; `more` are props for what draws it. */
export type Option<T, Words = string, More = object> = readonly [
  value: T,
  words: Words,
  more?: More & { [name: `data-${string}`]: string | undefined },
];

export type Words = ComponentChildren;
