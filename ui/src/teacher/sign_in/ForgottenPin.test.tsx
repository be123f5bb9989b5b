import { render } from "@testing-library/preact";
import { beforeAll, expect, test } from "vitest";
import { setLanguage, texts } from "../../i18n";
import { ForgottenPin } from "./ForgottenPin";

beforeAll(() => setLanguage("pt-BR"));

test("a forgotten PIN leads to the manual and names no command of a terminal", () => {
  const { door, prepare } = texts.value.teacher;
  for (const text of [door.forgotten, prepare.forgotten]) {
    const { container, getByRole, unmount } = render(<ForgottenPin text={text} />);
    expect(container.textContent).not.toMatch(/comando|pinel pin/);
    expect(getByRole("link").getAttribute("href")).toBe("#/manuals/teacher");
    unmount();
  }
});
