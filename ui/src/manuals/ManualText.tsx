import { type ComponentChild, h } from "preact";
import { withCommand } from "../shell/command";
import type { ManualNode } from "./model";

/** Content of a manual. Commands are named as they work on this PC. */
export function ManualText({ nodes }: { nodes: readonly ManualNode[] }) {
  return <>{nodes.map(drawn)}</>;
}

function drawn(node: ManualNode): ComponentChild {
  if (typeof node === "string") return node;
  if (node.tag === "code" || node.tag === "pre")
    return h(node.tag, null, withCommand(String(node.children[0])));
  const { tag, children, src, ...attributes } = node;
  if (tag === "img") return h(tag, { ...attributes, src, loading: "lazy" });
  return h(tag, attributes, ...children.map(drawn));
}
