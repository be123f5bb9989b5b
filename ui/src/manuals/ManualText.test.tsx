import { cleanup, render } from "@testing-library/preact";
import { afterEach, expect, test } from "vitest";
import { manualOf } from "../../manual_pages";

document.documentElement.dataset.command = "'/media/PEN DRIVE/PINEL/programa/pinel'";
const { ManualText } = await import("./ManualText");

afterEach(cleanup);

const shown = (markdown: string): string => {
  const nodes = manualOf("install", `# Title\n\n${markdown}`).sections.flatMap((one) => one.nodes);
  return render(<ManualText nodes={nodes} />).container.textContent ?? "";
};

test("a command is named as it works on this PC, in a line and in a block", () => {
  expect(shown("Type `pinel pin --hash`.")).toBe(
    "Type '/media/PEN DRIVE/PINEL/programa/pinel' pin --hash.",
  );
  expect(shown("```sh\npinel --self-check\n```")).toBe(
    "'/media/PEN DRIVE/PINEL/programa/pinel' --self-check",
  );
});

test("the name alone, a file and a package keep their names", () => {
  expect(shown("`pinel` `pinel.toml` `pinel-desktop` `./pinel`, and pinel pin")).toBe(
    "pinel pinel.toml pinel-desktop ./pinel, and pinel pin",
  );
});
