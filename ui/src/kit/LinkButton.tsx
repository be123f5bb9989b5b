import type { AnchorHTMLAttributes, Ref } from "preact";
import { type FaceProps, faceOf, type OwnAttributes } from "./face";

interface LinkButtonProps
  extends FaceProps,
    OwnAttributes,
    Omit<AnchorHTMLAttributes<HTMLAnchorElement>, keyof FaceProps | keyof OwnAttributes> {
  href: string;
  elementRef?: Ref<HTMLAnchorElement> | undefined;
}

/** A link to another screen, styled as a button. */
export function LinkButton(props: LinkButtonProps) {
  const { attributes, contents, rest: own } = faceOf(props);
  const { elementRef, ...rest } = own;
  return (
    <a {...rest} {...attributes} ref={elementRef ?? null}>
      {contents}
    </a>
  );
}
