import { namedSign } from "./named_sign";

/** The camera that sees signs, and practising them. */
export const camera = {
  picture: "Imagem da câmera, como num espelho",
  opening: "Abrindo a câmera…",
  choose: "Qual câmera usar",
  number: (n: number) => `Câmera ${n}`,
  other: "Outra fonte",
  showHand: "Mostrem a mão",
  noLetter: "Isto ainda não é uma letra",
  twoSigns: "Dois sinais: mostrem uma mão só",
  unsure: "Não sei bem:",
  either: (one: string, other: string) => `${one} ou ${other}?`,
  orElse: (letter: string) => `ou ${letter}`,
  hold: "Fiquem com a mão parada",
  sure: (sign: string, share: string) => `${namedSign(sign)}, ${share} de certeza`,
  steady: "Quanto falta para o sinal valer",
  expected: "O programa espera:",
  sign: (sign: string) => `Desenho: ${namedSign(sign)}`,
  noDrawing: (sign: string) => `${namedSign(sign)}, ainda sem desenho`,
  hands: {
    left: "Desenhos da mão esquerda: trocar",
    right: "Desenhos da mão direita: trocar",
  },
};

export const practice = {
  hint: "Façam uma letra em LIBRAS e segurem a mão parada.",
  seen: "Vejo a letra",
  spelled: "Pronto! Façam a próxima letra.",
  imitate: "Imitem esta letra",
  choose: "Letra para imitar",
  hand: "Mão",
  right: "Direita",
  left: "Esquerda",
  matched: (sign: string) => `É isso! ${namedSign(sign)}.`,
  text: "O que vocês escreveram",
  placeholder: "As letras aparecem aqui",
  space: "Espaço",
  back: "Apagar letra",
  clear: "Limpar",
  bringBack: "Trazer de volta",
  moving: "H, J, X, Y e Z: pelo teclado, ou ensinadas pela turma (experimental).",
  credits:
    "Letras aprendidas de “Alfabeto em libras” (elainesilva, CC BY 4.0); mãos: MediaPipe (Apache 2.0).",
};

/** Signs that a class teaches the camera. */
export const teaching = {
  title: "Ensinar um sinal",
  name: "Letra, ou nome do sinal",
  record: "Gravar",
  samples: (n: number) => `${n} imagens`,
  forget: (sign: string) => `Apagar o que foi gravado de ${sign}`,
  counted: (sign: string, n: number, of: number) =>
    `${sign}: ${n} de ${of}. Fiquem com a mão parada.`,
  kind: "Como é o sinal",
  still: "Fica parado",
  moves: "Se mexe",
  experimental: "experimental",
  suggested: "Letras que faltam",
  howStill: "Mostrem a mão parada até gravar dez imagens.",
  howMoving: "Cinco vezes: mão parada, façam o movimento, mão parada de novo.",
  movements: (n: number) => (n === 1 ? "1 movimento" : `${n} movimentos`),
  countedMoving: (sign: string, n: number, of: number) =>
    `${sign}: ${n} de ${of}. Parem a mão, façam o movimento, parem de novo.`,
  learnt: (sign: string) => `Pronto: a câmera conhece o sinal ${sign}.`,
};
