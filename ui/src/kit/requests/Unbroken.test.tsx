import { render } from "@testing-library/preact";
import { expect, test } from "vitest";
import { Unbroken } from "./Unbroken";

function unbroken(text: string): (string | null)[] {
  const { container } = render(<Unbroken text={text} />);
  expect(container.textContent).toBe(text);
  return [...container.querySelectorAll(".unbroken")].map((one) => one.textContent);
}

test("an option of a command and a date stay in one piece, a long path does not", () => {
  expect(unbroken("Use “pinel export --json” para ver.")).toEqual(["--json”"]);
  expect(unbroken("abra com outro arquivo (--db).")).toEqual(["(--db)."]);
  expect(unbroken("voltou a cópia de 2026-11-23 05:11.")).toEqual(["2026-11-23"]);
  expect(unbroken("avisem-nos: nada se perdeu")).toEqual([]);
  expect(unbroken("/uma/pasta/bem/comprida/pinel-00003-20261123.db")).toEqual([]);
});
