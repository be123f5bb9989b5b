import type { LucideIcon } from "lucide-preact";
import type { ComponentChildren } from "preact";

const KIND_CLASSES = {
  main: "button button--run",
  stop: "button button--stop",
  plain: "button button--plain",
  bare: "",
} as const;

/** Appearance shared by buttons and links styled as buttons. */
export interface AppearanceProps {
  icon?: LucideIcon | null | undefined;
  /** Icon after the text. */
  iconEnd?: LucideIcon | undefined;
  /** The icon is a solid shape. */
  filled?: boolean | undefined;
  /** Primary action; stops or deletes; no border; no style of the kit. */
  kind?: keyof typeof KIND_CLASSES | undefined;
  /** Accessible name; without children also the tooltip of the icon. */
  label?: string | undefined;
  /** Tooltip. */
  tip?: string | undefined;
  class?: string | undefined;
  testId?: string | undefined;
  children?: ComponentChildren;
}

/** Attributes that only the props above set. */
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

/** Splits props into attributes, contents and `rest` for the element. */
export function appearanceOf<P extends AppearanceProps>(props: P) {
  const { icon, iconEnd, filled, kind, label, tip, class: more, testId, children, ...rest } = props;
  const alone = children === undefined && kind !== "bare" ? "button--icon" : "";
  const kindClass = kind ? KIND_CLASSES[kind] : "button";
  const attributes = {
    class: [kindClass, alone, more].filter(Boolean).join(" "),
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
