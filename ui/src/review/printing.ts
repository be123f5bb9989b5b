import { hideTip } from "./tip";

/** The windows of some systems have no printing of their own. */
export const canPrint = () => typeof window.print === "function";

export function printPage(): void {
  hideTip();
  window.print();
}
