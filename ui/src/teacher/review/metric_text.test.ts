import { expect, test } from "vitest";
import { textsOf } from "../../i18n";
import { metricText } from "./metric_text";

test("the server says what each figure of the review counts", () => {
  const names = Object.keys(textsOf("pt-BR").review.figures).filter((name) => /_/.test(name));
  for (const name of names) expect(metricText(name).remedy, name).not.toBe("");
});
