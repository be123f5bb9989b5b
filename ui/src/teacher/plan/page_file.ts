import { language } from "../../i18n";
import { saveFile } from "../../shell/save_file";

/** What a rule names that is needed outside of the app: tokens, the printed parts, blocks, letters. */
const NEEDED = [
  ":root",
  ".plan",
  ".cards",
  ".card-",
  ".blockly",
  ".sign-drawing",
  ".pinel",
  "@page",
];

/** Saves an element as a page of its own, which opens and prints in any browser, without the app and without network. */
export async function savePage(
  element: HTMLElement | null,
  title: string,
  fileName: string,
): Promise<void> {
  if (!element) return;
  const styles = (await Promise.all([...document.styleSheets].flatMap(rulesOf))).join("\n");
  const page = document.createElement("html");
  page.lang = language.value;
  page.dataset.theme = "light";
  page.dataset.page = document.documentElement.dataset.page ?? "";
  page.dataset.apart = "true";
  const head = document.createElement("head");
  const name = document.createElement("title");
  name.textContent = title;
  const style = document.createElement("style");
  style.textContent = styles;
  head.innerHTML = '<meta charset="utf-8">';
  head.append(name, style);
  const body = document.createElement("body");
  body.append(element.cloneNode(true));
  page.append(head, body);
  const text = `<!doctype html>\n${page.outerHTML}`;
  saveFile(`${fileName}.html`, new Blob([text], { type: "text/html" }));
}

function rulesOf({ cssRules }: CSSStyleSheet): Promise<string>[] {
  return [...cssRules].flatMap((rule) => {
    if (rule instanceof CSSFontFaceRule) return [withFont(rule.cssText)];
    const isNeeded = NEEDED.some((name) => rule.cssText.includes(name));
    return isNeeded ? [Promise.resolve(rule.cssText)] : [];
  });
}

/** The rule of a font with the font itself, which a file beside no server cannot fetch. */
async function withFont(rule: string): Promise<string> {
  const address = /url\("([^"]+)"\)/.exec(rule)?.[1];
  if (!address || address.startsWith("data:")) return rule;
  const font = await (await fetch(address)).blob();
  return rule.replace(address, await dataAddress(font));
}

function dataAddress(blob: Blob): Promise<string> {
  const reader = new FileReader();
  return new Promise((resolve, reject) => {
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(reader.error ?? new Error("font unreadable"));
    reader.readAsDataURL(blob);
  });
}
