import { cleanup, render } from "@testing-library/preact";
import { afterEach, expect, test } from "vitest";
import { passesAxe } from "../testing/control";
import { FaultLine } from "./FaultLine";

afterEach(cleanup);

test("what only a technician can do is closed at first", async () => {
  const fault = { message: "Não foi possível gravar.", remedy: "Avisem.", details: "É /a/b.db." };
  const { container } = render(<FaultLine fault={fault} />);
  const details = container.querySelector("details");
  expect(details?.open).toBe(false);
  expect(details?.textContent).toBe("Para quem cuida do computadorÉ /a/b.db.");
  await passesAxe(container);
});

test("a message without it has nothing to open", () => {
  const { container } = render(<FaultLine fault={{ message: "Falta o nome.", remedy: "" }} />);
  expect(container.querySelector("details")).toBeNull();
});
