import { kioskApi } from "../../api/kiosk";
import { isKiosk } from "../kiosk";
import { asTeacher } from "../teacher/teacher_session";

/** Some webviews cannot print. */
export const canPrint = () => typeof window.print === "function";

/** Opens the print dialog. Kiosk mode asks for the PIN first, because the dialog leads to the files of the PC. */
export async function printPage(): Promise<void> {
  if (isKiosk()) await asTeacher(kioskApi.allowPrint);
  window.print();
}
