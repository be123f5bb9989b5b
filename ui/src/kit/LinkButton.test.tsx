import { render } from "@testing-library/preact";
import { ArrowLeft } from "lucide-preact";
import { describe, expect, test } from "vitest";
import { LinkButton } from "./LinkButton";
import { behavesAsControl } from "./testing/control";

describe("a link that looks like a button", () => {
  behavesAsControl(({ elementRef, ...props }) => (
    <LinkButton
      {...props}
      elementRef={elementRef as { current: HTMLAnchorElement | null }}
      href="#/"
    >
      Voltar
    </LinkButton>
  ));

  test("goes somewhere", () => {
    const { getByRole } = render(
      <LinkButton kind="main" icon={ArrowLeft} label="Voltar" href="#/" />,
    );
    const link = getByRole("link", { name: "Voltar" });
    expect(link.getAttribute("href")).toBe("#/");
    expect(link.className).toBe("button button--run button--icon");
  });
});
