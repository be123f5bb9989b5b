/** Elements that a manual consists of. */
export const MANUAL_TAGS = [
  "h1",
  "h2",
  "h3",
  "p",
  "ul",
  "ol",
  "li",
  "strong",
  "em",
  "a",
  "code",
  "pre",
  "img",
  "table",
  "thead",
  "tbody",
  "tr",
  "th",
  "td",
] as const;
export type ManualTag = (typeof MANUAL_TAGS)[number];

export interface ManualElement {
  readonly tag: ManualTag;
  /** Of a heading: its name in an address. */
  readonly id?: string;
  /** Of a link: the address of another place in the manuals. */
  readonly href?: string;
  /** Of a picture. */
  readonly src?: string;
  readonly alt?: string;
  readonly children: ManualNode[];
}

export type ManualNode = string | ManualElement;

/** The part of a manual under a heading; the first one has neither heading nor id. */
export interface ManualSection {
  readonly id: string;
  readonly title: string;
  readonly nodes: ManualNode[];
}

/** A page of docs/, made by ui/manuals.ts. */
export interface Manual {
  readonly name: string;
  readonly title: string;
  readonly sections: ManualSection[];
}
