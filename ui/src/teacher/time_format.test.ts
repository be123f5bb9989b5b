import { expect, test } from "vitest";
import { textsOf } from "../i18n";
import { relativeDateAndTime } from "../i18n/format";
import { LANGUAGES } from "../i18n/languages";
import { dateAndTime, timeOfDay } from "./time_format";

test.each(LANGUAGES)("a time of day has one form on every screen: %s", (language) => {
  const now = new Date();
  now.setHours(8, 5);
  const iso = now.toISOString();
  const plain = (text: string) => text.replace(/\s/g, " ");
  const time = `, ${plain(timeOfDay(iso, language))}`;
  expect(plain(relativeDateAndTime(iso, now, language, textsOf(language))).endsWith(time)).toBe(
    true,
  );
  expect(plain(dateAndTime(iso, language)).endsWith(time)).toBe(true);
});
