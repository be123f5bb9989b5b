import { cleanup, render, waitFor } from "@testing-library/preact";
import { afterEach, expect, test } from "vitest";
import { StatusLine } from "./StatusLine";

afterEach(cleanup);

test.each([
  ["Em pausa.", "Apertem Continuar.", "Em pausa. Apertem Continuar."],
  ["O programa terminou", "volta 2", "O programa terminou. volta 2"],
  ["Tudo pronto. Apertem Rodar.", "", "Tudo pronto. Apertem Rodar."],
])("%s and %s are read aloud as sentences", async (text, more, announcement) => {
  const { getByRole } = render(<StatusLine sentence={{ text, detail: more, tone: "calm" }} />);
  await waitFor(() => expect(getByRole("status").textContent).toBe(announcement));
});
