// The editor without the page around it, for tests with very large programs.
import { createEditor } from "../../../ui/src/editor";
import { fetchTexts } from "../../../ui/src/i18n";
import "virtual:texts/pt-BR/start"; // bundled into the same file as the code

await fetchTexts("pt-BR");

Object.assign(window, { createEditor });
