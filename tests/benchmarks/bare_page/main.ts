// The editor of the page and nothing else: no server of ours, no run, no floor, no history.
import { createEditor } from "../../../ui/src/editor";
import { fetchTexts } from "../../../ui/src/i18n";
import "virtual:texts/pt-BR/start"; // in the same file as the code

await fetchTexts("pt-BR");

const container = document.getElementById("editor");
if (container) {
  createEditor({ container, language: "pt-BR", theme: "light", mediaPath: "./", onChange: () => {} }).load(null);
}
