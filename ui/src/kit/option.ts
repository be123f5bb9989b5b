import type { ComponentChildren } from "preact";

/** A value with its label; `more` are props for its element. */
export type Option<T, Label = string, More = object> = readonly [
  value: T,
  label: Label,
  more?: More & { [name: `data-${string}`]: string | undefined },
];

export type LabelContent = ComponentChildren;
