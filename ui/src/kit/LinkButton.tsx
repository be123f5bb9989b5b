import type { AnchorHTMLAttributes, Ref } from "preact";
import { type AppearanceProps, appearanceOf, type OwnAttributes } from "./appearance";

interface LinkButtonProps
  extends AppearanceProps,
    OwnAttributes,
    Omit<AnchorHTMLAttributes<HTMLAnchorElement>, keyof AppearanceProps | keyof OwnAttributes> {
  href: string;
  elementRef?: Ref<HTMLAnchorElement> | undefined;
}

/** A link to another screen, styled as a button. */
export function LinkButton(props: LinkButtonProps) {
  const { attributes, contents, rest: own } = appearanceOf(props);
  const { elementRef, ...rest } = own;
  return (
    <a {...rest} {...attributes} ref={elementRef ?? null}>
      {contents}
    </a>
  );
}
