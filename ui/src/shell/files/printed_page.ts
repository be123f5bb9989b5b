import { useEffect } from "preact/hooks";

/** Sets the name of the printed page, by which the print rules hide everything around it. */
export function usePrintedPage(name: "plan" | "cards" | "album"): void {
  useEffect(() => {
    document.documentElement.dataset.page = name;
    return () => {
      delete document.documentElement.dataset.page;
    };
  }, [name]);
}
