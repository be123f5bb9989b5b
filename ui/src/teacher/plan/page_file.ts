import { language } from "../../i18n";
import { saveFile } from "../../shell/files/save_file";

/** Parts of the CSS rules that the saved page needs: style tokens, printed parts, blocks, signs. */
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

/** Saves an element as a separate page that any browser opens and prints, without the app and the network. */
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

function rulesOf({ cssRules }: CSSStyleSheet | CSSMediaRule): Promise<string>[] {
  return [...cssRules].flatMap((rule) => {
    if (rule instanceof CSSFontFaceRule) return [withFont(rule.cssText)];
    if (rule instanceof CSSMediaRule && rule.conditionText === "all") return rulesOf(rule);
    const isNeeded = NEEDED.some((name) => rule.cssText.includes(name));
    return isNeeded ? [Promise.resolve(rule.cssText)] : [];
  });
}

/** A font's rule with the font as a data URL: a saved file has no server from which to fetch the font. */
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
