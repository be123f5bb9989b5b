/** Run before each file of tests: the texts of every language are there, and need no waiting for. */
import { fetchLaterTexts, fetchTexts } from "..";
import { LANGUAGES } from "../languages";

await fetchLaterTexts();
await Promise.all(LANGUAGES.map(fetchTexts));
