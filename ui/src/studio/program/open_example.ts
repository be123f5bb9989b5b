import { api } from "../../api/client";
import type { Example } from "../../api/model";
import { go } from "../../shell/route";
import { setupOf } from "./setup";

/** Creates a program of the group with the blocks and the world of an example, and opens it. */
export async function openExample(
  group: string,
  { title, document, world }: Example,
): Promise<void> {
  const { contentOf } = await import("../../editor/content_of");
  const content = contentOf(document);
  const { id } = await api.createProgram(group, title);
  await api.saveVersion(id, { ...content, setup: { ...setupOf(null), world } });
  go({ screen: "studio", program: id });
}
