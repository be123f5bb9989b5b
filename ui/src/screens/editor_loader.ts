/** The editor is the heaviest part of the page; it is fetched while the group still reads its name. */
let loading: Promise<typeof import("../editor")> | null = null;

export function loadEditor(): Promise<typeof import("../editor")> {
  loading ??= import("../editor");
  return loading;
}
