import { namedSign } from "./named_sign";

/** The camera that sees signs, and practising them. */
export const camera = {
  picture: "Imagen de la cámara, como en un espejo",
  opening: "Abriendo la cámara…",
  choose: "Qué cámara usar",
  number: (n: number) => `Cámara ${n}`,
  other: "Otra fuente",
  showHand: "Muestren la mano",
  noLetter: "Esto todavía no es una letra",
  twoSigns: "Dos señas: muestren una sola mano",
  unsure: "No es seguro:",
  either: (one: string, other: string) => `¿${one} o ${other}?`,
  orElse: (letter: string) => `o ${letter}`,
  hold: "Dejen la mano quieta",
  sure: (sign: string, share: string) => `${namedSign(sign)}, ${share} de seguridad`,
  steady: "Cuánto falta para que la seña valga",
  expected: "El programa espera:",
  sign: (sign: string) => `Dibujo: ${namedSign(sign)}`,
  noDrawing: (sign: string) => `${namedSign(sign)}, todavía sin dibujo`,
  hands: {
    left: "Dibujos de la mano izquierda: cambiar",
    right: "Dibujos de la mano derecha: cambiar",
  },
};

export const practice = {
  hint: "Hagan una letra en LIBRAS y dejen la mano quieta.",
  seen: "Veo la letra",
  spelled: "¡Listo! Hagan la letra siguiente.",
  imitate: "Imiten esta letra",
  choose: "Letra para imitar",
  hand: "Mano",
  right: "Derecha",
  left: "Izquierda",
  matched: (sign: string) => `¡Eso es! ${namedSign(sign)}.`,
  text: "Lo que escribieron",
  placeholder: "Las letras aparecen aquí",
  space: "Espacio",
  back: "Borrar letra",
  clear: "Limpiar",
  bringBack: "Traer de vuelta",
  moving: "H, J, X, Y y Z: con el teclado, o enseñadas por el curso (experimental).",
  credits:
    "Letras aprendidas de “Alfabeto em libras” (elainesilva, CC BY 4.0); manos: MediaPipe (Apache 2.0).",
};

/** Signs that a class teaches the camera. */
export const teaching = {
  title: "Enseñar una seña",
  name: "Letra, o nombre de la seña",
  record: "Grabar",
  samples: (n: number) => `${n} imágenes`,
  forget: (sign: string) => `Borrar lo que se grabó de ${sign}`,
  counted: (sign: string, n: number, of: number) =>
    `${sign}: ${n} de ${of}. Mantengan la mano quieta.`,
  kind: "Cómo es la seña",
  still: "Queda quieta",
  moves: "Se mueve",
  experimental: "experimental",
  suggested: "Letras que faltan",
  howStill: "Muestren la mano quieta hasta grabar diez imágenes.",
  howMoving: "Cinco veces: mano quieta, hagan el movimiento, mano quieta otra vez.",
  movements: (n: number) => (n === 1 ? "1 movimiento" : `${n} movimientos`),
  countedMoving: (sign: string, n: number, of: number) =>
    `${sign}: ${n} de ${of}. Paren la mano, hagan el movimiento, paren otra vez.`,
  learnt: (sign: string) => `Listo: la cámara conoce la seña ${sign}.`,
};
