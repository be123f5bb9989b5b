import type { LucideIcon } from "lucide-preact";
import type { ComponentChildren } from "preact";

const LOOKS = {
  main: "button button--run",
  stop: "button button--stop",
  plain: "button button--plain",
  bare: "",
} as const;

/** What a button and a link that looks like one have in common. */
export interface FaceProps {
  icon?: LucideIcon | null | undefined;
  /** Stands after the words. */
  iconEnd?: LucideIcon | undefined;
  /** The icon is a solid shape. */
  filled?: boolean | undefined;
  /** The one thing to do next; ends or deletes something; without a frame; without any look of the kit. */
  kind?: keyof typeof LOOKS | undefined;
  /** The name for who cannot see it. Without children the icon stands alone and this is its tip too. */
  label?: string | undefined;
  /** Shown when the pointer rests on it. */
  tip?: string | undefined;
  class?: string | undefined;
  testId?: string | undefined;
  children?: ComponentChildren;
}

/** These attributes come from the props above alone. */
export interface OwnAttributes {
  type?: never;
  title?: never;
  role?: never;
  onClick?: never;
  "aria-label"?: never;
  "aria-pressed"?: never;
  "aria-expanded"?: never;
  "aria-busy"?: never;
  "aria-current"?: never;
  "aria-selected"?: never;
  "data-testid"?: never;
}

/** Attributes and contents from the props of a face; `rest` is for the element. */
export function faceOf<P extends FaceProps>(props: P) {
  const { icon, iconEnd, filled, kind, label, tip, class: more, testId, children, ...rest } = props;
  const alone = children === undefined && kind !== "bare" ? "button--icon" : "";
  const look = kind ? LOOKS[kind] : "button";
  const attributes = {
    class: [look, alone, more].filter(Boolean).join(" "),
    title: tip ?? (children === undefined ? label : undefined),
    "aria-label": label,
    "data-testid": testId,
  };
  const contents = (
    <>
      <Icon of={icon} filled={filled ?? false} />
      {children}
      <Icon of={iconEnd} filled={false} />
    </>
  );
  return { attributes, contents, rest };
}

function Icon({ of: Drawing, filled }: { of: LucideIcon | null | undefined; filled: boolean }) {
  if (!Drawing) return null;
  return <Drawing class="icon" aria-hidden="true" {...(filled && { fill: "currentColor" })} />;
}
