/** Run before each file of tests: the texts of every language are there, and need no waiting for. */
import { fetchLazyTexts, fetchTexts } from "..";
import { LANGUAGES } from "../languages";

await fetchLazyTexts();
await Promise.all(LANGUAGES.map(fetchTexts));
